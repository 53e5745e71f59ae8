"""Pose bones as controls: their turns, with locks and limits in the angles that Blender applies them to, and places and scales."""
import math

from mathutils import Euler, Quaternion

from .controls import Refused, found, within
from .held import Held, Member

RIGHT_ANGLE = 0.5 * math.pi
OWN = 'ZYX'  # Blender's name for Rx Ry Rz, which a joint of penpose is turned by


def limit_of(bone, kind='LIMIT_ROTATION'):
    """The own limit of a bone or object that is in force, or None."""
    for constraint in bone.constraints:
        if constraint.type == kind and not constraint.mute and constraint.owner_space == 'LOCAL' and \
                constraint.influence == 1:
            return constraint
    return None


def locks_components(bone):
    """Whether its locks are of components of its quaternion (or of its axis and angle) instead of angles."""
    return bone.rotation_mode in ('QUATERNION', 'AXIS_ANGLE') and bone.lock_rotations_4d and \
        (any(bone.lock_rotation) or bone.lock_rotation_w)


def may_turn(bone):
    """Whether its locks leave any turn free. Of a locked component of axis and angle, and of a locked w, all is held."""
    if locks_components(bone) and (bone.lock_rotation_w or bone.rotation_mode == 'AXIS_ANGLE'):
        return False
    return not all(bone.lock_rotation)


def order_of_locks(bone):
    """The angles that Blender's locks hold: those of its own mode, or XYZ."""
    return 'XYZ' if bone.rotation_mode in ('QUATERNION', 'AXIS_ANGLE') else bone.rotation_mode


def order_of_limit(bone):
    """The angles that the limit of a bone is of."""
    order = limit_of(bone).euler_order
    return order_of_locks(bone) if order == 'AUTO' else order


def limits_of(bone):
    """[(least, most)] of the three angles; None where there is no limit."""
    constraint = limit_of(bone)
    out = []
    for letter in 'xyz':
        if constraint is not None and getattr(constraint, 'use_limit_' + letter):
            ends = getattr(constraint, 'min_' + letter), getattr(constraint, 'max_' + letter)
            out.append((min(ends), max(ends)))
        else:
            out.append(None)
    return out


def turn_of(bone):
    """The rotation that a pose bone has, whatever its mode."""
    if bone.rotation_mode == 'QUATERNION':
        return bone.rotation_quaternion.normalized()
    if bone.rotation_mode == 'AXIS_ANGLE':
        angle, *axis = bone.rotation_axis_angle
        return Quaternion(axis, angle)
    return bone.rotation_euler.to_quaternion()


def limited(bone, turn):
    """A rotation as the limit of the bone leaves it."""
    limits = limits_of(bone)
    if not any(limits):
        return turn
    angles = turn.to_matrix().to_euler(order_of_limit(bone))
    inside = [a if limit is None else min(limit[1], max(limit[0], a)) for a, limit in zip(angles, limits)]
    return turn if list(angles) == inside else Euler(inside, angles.order).to_quaternion()


def seen_turn(bone):
    """The rotation that Blender shows of a bone that no other constraint acts on."""
    return limited(bone, turn_of(bone))


def set_turn(bone, turn):
    """Turns a pose bone in its own mode; what is locked stays, and limits are kept."""
    lock, turn = bone.lock_rotation, limited(bone, turn)
    if bone.rotation_mode in ('QUATERNION', 'AXIS_ANGLE'):
        if any(lock):
            old, new = turn_of(bone).to_euler('XYZ'), turn.to_euler('XYZ')
            turn = Euler([o if locked else n for o, n, locked in zip(old, new, lock)], 'XYZ').to_quaternion()
        if bone.rotation_mode == 'AXIS_ANGLE':
            axis, angle = turn.to_axis_angle()
            bone.rotation_axis_angle = (angle, *axis)
            return
        if bone.rotation_quaternion.dot(turn) < 0:
            turn = -turn
        bone.rotation_quaternion = _with_components(bone, turn) if locks_components(bone) else turn
        return
    old = bone.rotation_euler.copy()
    new = turn.to_euler(bone.rotation_mode, old)
    bone.rotation_euler = Euler([o if locked else n for o, n, locked in zip(old, new, lock)], bone.rotation_mode)


def _with_components(bone, turn):
    """The nearest quaternion of length 1 that has the locked components of the bone's own."""
    old = bone.rotation_quaternion.normalized()
    held = [False, *bone.lock_rotation]
    out = [o if h else n for o, n, h in zip(old, turn, held)]
    rest = math.sqrt(max(0.0, 1 - sum(o * o for o, h in zip(out, held) if h)))
    length = math.sqrt(sum(o * o for o, h in zip(out, held) if not h))
    return old if length < 1e-9 else Quaternion([o if h else o * rest / length for o, h in zip(out, held)])


def rotation_path(bone):
    """The channel that holds a bone's rotation."""
    return {'QUATERNION': 'rotation_quaternion', 'AXIS_ANGLE': 'rotation_axis_angle'}.get(bone.rotation_mode, 'rotation_euler')


class _OfBone:
    """Finds its pose bone again."""

    def __init__(self, armature, bone):
        self.held, self.member = Held(armature), Member(bone)

    @property
    def bone(self):
        """The name of the bone."""
        return self.member.name

    @property
    def object(self):
        """The name of the armature."""
        return self.held.name

    def pose_bone(self):
        """The bone. Raises Refused."""
        bone = self.member.of(found(self.held).pose.bones)
        if bone is None:
            raise Refused('%s has no bone %s any more; draw again' % (self.held.name, self.member.name))
        return bone


class BoneTurn(_OfBone):
    """The turn of a pose bone: three angles, those about x, y and z in an order."""

    def __init__(self, armature, bone, order=OWN):
        super().__init__(armature, bone)
        self.order = order
        self.names = ['%s.r%s' % (bone.name, axis) for axis in 'xyz']
        now = self.angles()
        self.limits = []
        for axis, limit in enumerate(limits_of(bone)):
            least, most = limit or (-RIGHT_ANGLE, RIGHT_ANGLE)
            if 'XYZ'[axis] == order[1]:
                # The middle one of three angles has half of the circle.
                least, most = max(-RIGHT_ANGLE, least), min(RIGHT_ANGLE, most)
            self.limits.append((min(least, now[axis]), max(most, now[axis])))

    @property
    def name(self):
        """As messages call it."""
        return self.bone

    def angles(self):
        return list(seen_turn(self.pose_bone()).to_matrix().to_euler(self.order))

    def turn_to(self, angles):
        set_turn(self.pose_bone(), Euler(angles, self.order).to_quaternion())

    def get(self):
        return self.angles()

    def set(self, values):
        self.turn_to(values)

    def rest(self):
        return [0.0] * 3

    def locked(self):
        """Which of the three the bone's own locks hold."""
        return list(self.pose_bone().lock_rotation)

    def range(self, axis):
        """Least and most of an angle; 0, which is rest, lies in it."""
        least, most = self.limits[axis]
        return min(0.0, least), max(0.0, most)

    def is_held(self):
        """Whether locks or limits of Blender's own angles may leave another turn than was asked for."""
        bone = self.pose_bone()
        return any(bone.lock_rotation) or any(limits_of(bone))

    def kept(self):
        bone = self.pose_bone()
        return rotation_path(bone), list(getattr(bone, rotation_path(bone)))

    def give_back(self, kept):
        setattr(self.pose_bone(), *kept)

    def channels(self):
        bone = self.pose_bone()
        return [(bone, rotation_path(bone), -1, bone.name)]


class BoneAngle:
    """One angle of a pose bone as a control of its own, near where it is."""

    REACH = 0.6  # radians to either side that a bone may turn before it is measured again
    STEP = 0.05

    def __init__(self, turn, axis):
        self.turn, self.axis = turn, axis
        self.name = turn.names[axis]
        self.now = self.get()

    @property
    def bone(self):
        """The name of the bone."""
        return self.turn.bone

    def get(self):
        return self.turn.angles()[self.axis]

    def set(self, value):
        angles = self.turn.angles()
        angles[self.axis] = value
        self.turn.turn_to(angles)

    def rest(self):
        return self.now

    def range(self):
        least, most = self.turn.limits[self.axis]
        return max(least, self.now - self.REACH), min(most, self.now + self.REACH)

    def kept(self):
        return self.turn.kept()

    def give_back(self, kept):
        self.turn.give_back(kept)

    def channels(self):
        return self.turn.channels()


class Channel:
    """One number of a location, a scale or (of an object) a rotation as a control of its own, near where it is.

    `reach`: how far it may go to either side where no limit says so; measured, for what a unit does is the rig's affair. Scales go to half
    and to double."""

    LIMITS = {'location': 'LIMIT_LOCATION', 'scale': 'LIMIT_SCALE', 'rotation_euler': 'LIMIT_ROTATION'}
    LETTERS = {'location': '', 'scale': 's', 'rotation_euler': 'r'}

    def __init__(self, owner, path, axis, step, armature=None):
        self.of_bone = _OfBone(armature, owner) if armature is not None else None
        self.held = Held(owner) if armature is None else None
        self.path, self.axis, self.STEP, self.reach = path, axis, step, 0.0
        self.name = '%s.%s%s' % (owner.name, self.LETTERS[path], 'xyz'[axis])
        self.now = self.get()

    @property
    def bone(self):
        """The name of the bone; empty for an object."""
        return self.of_bone.bone if self.of_bone else ''

    def owner(self):
        """The bone or object. Raises Refused."""
        return self.of_bone.pose_bone() if self.of_bone else found(self.held)

    def limit(self):
        """Least and most that a constraint leaves; None where it leaves all."""
        owner, letter = self.owner(), 'xyz'[self.axis]
        one = limit_of(owner, self.LIMITS[self.path])
        if one is None:
            return None, None
        if self.path == 'rotation_euler':
            return (getattr(one, 'min_' + letter), getattr(one, 'max_' + letter)) if getattr(one, 'use_limit_' + letter) else (None, None)
        return tuple(getattr(one, end + letter) if getattr(one, 'use_%s%s' % (end, letter)) else None for end in ('min_', 'max_'))

    def rest(self):
        return self.now

    def range(self):
        least, most = self.limit()
        far = sorted((0.5 * self.now, 2 * self.now)) if self.path == 'scale' else (self.now - self.reach, self.now + self.reach)
        least, most = far[0] if least is None else least, far[1] if most is None else most
        return min(least, self.now), max(most, self.now)

    def get(self):
        return getattr(self.owner(), self.path)[self.axis]

    def set(self, value):
        least, most = self.limit()
        value = within(value, value if least is None else least, value if most is None else most)
        getattr(self.owner(), self.path)[self.axis] = value

    def kept(self):
        return self.get()

    def give_back(self, kept):
        getattr(self.owner(), self.path)[self.axis] = kept

    def channels(self):
        return [(self.owner(), self.path, self.axis, self.bone)]
