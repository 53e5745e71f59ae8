"""A character of Blender as one of penpose: the surface that is drawn on, and what of the rig each parameter is.

Keys and bones that nothing else acts upon are taken as they are (taken.py), so that penpose and Blender agree to rounding. Where drivers,
constraints or modifiers act between, what each control does is measured instead (measure.py), once a curve says where it matters.
"""
import time

import numpy as np

from . import measure, taken
from .candidates import candidates, extent, selected
from .character import armature_of, parts_of
from .controls import TINY, Refused
from .library import Character
from .reach import Graph
from .surface import Surface
from .taken import Mesh  # noqa: F401 the rig tool's

MOST_VERTICES = 1000000
LINKED = 'make a library override of the whole character (Object > Library Override > Make)'


def _check_armature(obj, armature):
    if armature.library is not None:
        raise Refused('%s, which carries %s, is linked; %s' % (armature.name, obj.name, LINKED))
    if armature.data.pose_position == 'REST':
        raise Refused('%s, which carries %s, is shown at rest; set it to Pose Position in the properties of the armature' % (
            armature.name, obj.name))
    if abs(armature.matrix_world.determinant()) < 1e-30:
        raise Refused('%s, which carries %s, has a scale of 0; give it another' % (armature.name, obj.name))


def check(obj):
    """Refuses what cannot be drawn on."""
    if obj is None or obj.type != 'MESH':
        raise Refused('%s is no mesh; select the mesh that is to be drawn on' % (obj.name if obj is not None else 'what is active'))
    if obj.mode not in ('OBJECT', 'POSE'):
        raise Refused('%s is in %s mode; go to Object or Pose mode' % (obj.name, obj.mode.lower().replace('_', ' ')))
    if obj.library is not None:
        raise Refused('%s is linked; %s' % (obj.name, LINKED))
    if any(m.type == 'MULTIRES' and m.show_viewport and m.levels > 0 for m in obj.modifiers):
        raise Refused('%s has Multires levels in the viewport; set its Level Viewport to 0' % obj.name)
    if len(obj.data.vertices) > MOST_VERTICES:
        raise Refused('%s has %d vertices, more than %d; draw on a lighter copy that the same rig moves' %
                      (obj.name, len(obj.data.vertices), MOST_VERTICES))
    if not obj.data.polygons:
        raise Refused('%s has no faces to draw on' % obj.name)
    keys = obj.data.shape_keys
    if keys is not None and not keys.use_relative:
        raise Refused('the shape keys of %s are not relative; tick Relative in the panel Shape Keys' % obj.name)
    if keys is not None and obj.show_only_shape_key:
        raise Refused('%s shows a single shape key alone; turn off the pin in the panel Shape Keys' % obj.name)
    if abs(obj.matrix_world.determinant()) < 1e-30:
        raise Refused('%s has a scale of 0; give it another' % obj.name)
    armature = armature_of(obj)
    if armature is not None:
        _check_armature(obj, armature)


class Rig:
    """A character and what of Blender each of its parameters is.

    `character`: penpose's; `parts`: [(control, parameters, whether it may move)], in the order of the pose; `surface`: what is drawn
    on; `measured`: why controls are measured, or an empty text; `took_s`: how long that took, `left`: controls that were not tried."""

    def __init__(self, obj, near=None, measured=True):
        check(obj)
        objects = parts_of(obj)
        seen = [o for o in objects if o.visible_get()] or [obj]
        self.objects = [o for o in objects if o not in seen]
        self.surface = Surface(seen)
        self.graph = Graph(self.surface)
        armatures = [a for a in self.graph.armatures if any(taken.carriers_of(o, a) for o in seen)]
        for armature in armatures:
            _check_armature(obj, armature)
        self.measured, self.took_s, self.left = taken.acts_between(self.surface, armatures, self.graph.driven), 0.0, 0
        self.shown, self.found, self.broad = None, None, set()
        self.name = obj.name
        if self.measured:
            self.candidates = candidates(self.graph, objects, extent(self.surface.rest))
            if not self.candidates:
                self._nothing(obj)
            self.measure(near(self.surface) if near is not None else None) if measured else self.bare()
        else:
            self._take(armatures[0] if armatures else None)
            if not any(free for _, _, free in self.parts):
                self._nothing(obj)
        self.take_pose()

    def _nothing(self, obj):
        keys = obj.data.shape_keys
        if keys is not None and keys.library is not None:
            raise Refused('the shape keys of %s are linked, and nothing else moves it; make a library override of its mesh too' % obj.name)
        raise Refused('%s has nothing to pose: no shape key and no bone that moves it; New Key by Drawing makes one' % obj.name)

    @property
    def mesh(self):
        """The surface, which has a space, triangles and places at rest."""
        return self.surface

    def space(self):
        """Where the character lies now."""
        return self.surface.space

    def _take(self, armature):
        shapes, keys, lifted = taken.shapes_of(self.surface, self.objects)
        skin = taken.Skin(self.surface, armature) if armature else None
        joints = {} if skin is None else {'joints': skin.joints, 'joint_of': skin.joint_of, 'weight_of': skin.weight_of}
        self.character = Character.from_arrays(lifted, self.surface.triangles, shapes, **joints)
        self.parts = [(control, [i], free) for i, (control, free) in enumerate(keys)]
        for turn in skin.turns if skin else []:
            first = self.parts[-1][1][-1] + 1 if self.parts else 0
            self.parts.append((turn, list(range(first, first + len(turn.rest()))), True))
        self._ranges()

    def bare(self):
        """The surface alone, for a curve that is drawn on it."""
        self.shown = self.surface.look()
        base = self.shown if self.shown is not None else self.surface.rest
        self.character, self.parts, self.found = Character.from_arrays(base, self.surface.triangles), [], None
        self._ranges()

    def measure(self, near=None, again=None):
        """Measures what may move the vertices that curves lie on (None: any). `again`: only these controls are looked at anew."""
        trials = measure.Trials(self.surface)
        try:
            if again is None:
                wanted = measure.chosen(self.candidates, near, trials.now)
                found, self.left = trials.measure(wanted)
                found = measure.settled(found, trials.now, near)
                self.broad = {id(one.candidate) for one in measure.broad(found, trials.now, near)}
            else:
                again = {id(control) for control in again}
                fresh, _ = trials.measure([one.candidate for one in self.found if id(one.control) in again])
                found = [one for one in self.found if id(one.control) not in again] + fresh
                for one in found:
                    one.renew()
            self.took_s = time.perf_counter() - trials.begin
        finally:
            trials.end()
        self._become(found, trials.now)

    def _become(self, found, now):
        base, self.shapes = measure.shapes_of(found, now)
        self.found, self.parts = found, []
        self.character = Character.from_arrays(base, self.surface.triangles, self.shapes)
        for one in found:
            first = self.parts[-1][1][-1] + 1 if self.parts else 0
            self.parts.append((one.control, [first] if one.straight else [first, first + 1], True))
        self.shown = self.surface.look()
        self._ranges()

    def _ranges(self):
        self.offsets = np.array([value for control, _, _ in self.parts for value in _listed(control.rest())])
        limits = self.character.parameters
        self.least, self.most = np.array([p.minimum for p in limits]), np.array([p.maximum for p in limits])
        self.names, self.locked = [p.name for p in limits], [False] * len(limits)
        self._lock()

    def holds(self):
        """Whether what was measured, or the ranges that were taken, are those of what Blender has now; the character takes its pose."""
        if self.measured and self.found is None:
            shown = self.surface.look()
            return shown is None and self.shown is None or \
                shown is not None and self.shown is not None and np.array_equal(shown, self.shown)
        if self.measured:
            self.take_pose()
            return self.shown is None or self.shows()
        values = self.take_pose()
        return bool((values >= self.least - TINY).all() and (values <= self.most + TINY).all())

    def _lock(self, may_move=None):
        for control, numbers, free in self.parts:
            free = free and (may_move is None or may_move(control))
            held = [True] * len(numbers) if not free else [False] if len(numbers) == 1 else control.locked()
            for number, locked in zip(numbers, held):
                if self.locked[number] != bool(locked):
                    self.character.lock(self.names[number], bool(locked))
                    self.locked[number] = bool(locked)

    def limit(self, chosen, wide=False):
        """Lets only the chosen controls move (candidates.selected()); None: all. The parameters that lines are read by: `wide`: all, else
        without controls that carry much more than what is drawn on, which are meant where no other can follow; and whether that leaves
        any out."""
        if chosen is not None and not any(free and selected(control, *chosen) for control, _, free in self.parts):
            raise Refused('none of what is selected moves the curve on %s; select other bones, or turn off Selected Only' % self.name)
        self._lock(lambda control: chosen is None or selected(control, *chosen))
        narrow = [i for i, one in enumerate(self.found or ()) if id(one.candidate) not in self.broad]
        if wide or not any(chosen is None or selected(self.parts[i][0], *chosen) for i in narrow):
            narrow = range(len(self.parts))
        return [n for i in narrow for n in self.parts[i][1]], len(narrow) < len(self.parts)

    def only(self, controls):
        """Lets only these controls move."""
        self._lock(lambda control: any(control is one for one in controls))

    def numbers_of(self, controls):
        """The parameters of controls."""
        return [n for control, numbers, _ in self.parts if any(control is one for one in controls) for n in numbers]

    def is_moved(self):
        """The controls that the character has elsewhere than Blender."""
        off = np.abs(self.character.pose - np.clip(self.pose() - self.offsets, self.least, self.most)) > TINY
        return [control for control, numbers, _ in self.parts if off[numbers].any()]

    def same(self, controls):
        """The controls that stand for earlier ones after they were measured again."""
        plain = [getattr(control, 'control', control) for control in controls]
        return [c for c, _, _ in self.parts if any(getattr(c, 'control', c) is one for one in plain)]

    def answers_otherwise(self):
        """Whether Blender may show another pose than the one that is solved for, so that it is solved again from there."""
        return bool(self.measured) or any(getattr(control, 'is_held', bool)() for control, _, _ in self.parts)

    def shows(self):
        """Whether Blender shows the vertices where the character has them at its pose: what was measured then holds there, too."""
        wanted, shown = self.character.evaluate(), self.surface.look()
        return shown is not None and bool(np.abs(shown - wanted).max() <= measure.NEAR * extent(wanted))

    def become_file(self):
        """Makes the character what its own file holds, to the bit, for a file rounds joints and weights. The file, .glb."""
        data = b''
        for _ in range(4):
            before, data = data, self.character.write('.glb')
            if data == before:
                break
            self.character = Character.read(data, 'model.glb')
            self.locked = [False] * len(self.names)
            self._lock()
        return data

    def pose(self):
        """What Blender has now, one value a parameter: of keys and properties their values, of bones angles."""
        return np.array([value for control, _, _ in self.parts for value in _listed(control.get())])

    def take_pose(self):
        """Tells the character what Blender has, where that differs; that, as it is."""
        now = self.pose() - self.offsets
        if np.abs(now - self.character.pose).max(initial=0.0) > TINY:
            self.character.pose = np.clip(now, self.least, self.most)
        return now

    def apply(self, values, since=None):
        """Sets Blender's controls to a pose of the character; those that it leaves alone are not touched. `since`: a pose that they
        were set to; only what differs is looked at. The controls that moved."""
        moved = []
        changed = None if since is None else np.abs(values - since) > TINY
        for control, numbers, free in self.parts:
            if not free or changed is not None and not changed[numbers].any():
                continue
            new = [float(values[n] + self.offsets[n]) for n in numbers]
            if max(abs(a - b) for a, b in zip(new, _listed(control.get()))) <= TINY:
                continue
            control.set(new[0] if len(numbers) == 1 else new)
            moved.append(control)
        return moved

    def kept(self):
        """What give_back() brings back to the bit."""
        return [(control, control.kept(), control.get()) for control, _, free in self.parts if free]

    def moved_from(self, pose, among=None):
        """The controls that differ from an earlier pose() of the same parameters. `among`: only these are looked at."""
        return [control for control, numbers, _ in self.parts if (among is None or any(control is one for one in among)) and
                max(abs(a - pose[n]) for a, n in zip(_listed(control.get()), numbers)) > TINY]

    def changed_from(self, kept):
        """The controls that differ from an earlier kept()."""
        return [control for control, _, value in kept if max(abs(a - b) for a, b in zip(_listed(control.get()), _listed(value))) > TINY]


def _listed(value):
    return value if isinstance(value, list) else [value]


def give_back(kept):
    """Brings back what Rig.kept() had of what is still there."""
    for control, value, _ in kept:
        try:
            if control.kept() != value:
                control.give_back(value)
        except (Refused, ReferenceError, KeyError, AttributeError):
            continue
