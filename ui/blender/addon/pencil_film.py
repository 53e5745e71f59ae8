"""A pencil test becomes an animation: each drawing of a face by Grease Pencil poses the character and is keyed on its frame."""
import bpy

from . import drawing, keys
from .controls import TINY, Refused
from .grease import drawings_of, pencil_of, shown_on_frame, target_mesh
from .library import Error
from .pen import begin, ended, redraw, running, seen_in, tell_moved


class Film:
    """The drawings of a Grease Pencil, read one by one; nothing moves before key(). `left`: a line for each that was not read."""

    def __init__(self, obj, pencil, seen):
        self.object, self.rig, self.view = obj, drawing.known(obj, wholly=True).rig, seen.view
        self.rig.take_pose()
        self.now = self.rig.character.pose
        self.waiting = list(drawings_of(pencil).items())
        if not self.waiting:
            raise Refused('%s has no drawing; draw the face with Grease Pencil on some frames' % pencil.name)
        self.count, self.poses, self.left, self.unknown = len(self.waiting), {}, [], 0

    def step(self):
        """Reads the next drawing. Whether there was one."""
        if not self.waiting:
            return False
        frame, (lines, rest) = self.waiting.pop(0)
        try:
            self.poses[frame], unknown = read(self.rig, lines, rest, self.view)
            self.unknown += unknown
        except Error as problem:
            self.left.append('frame %d is left out: %s' % (frame, problem))
        return True

    def key(self, scene):
        """Keys all that was read, on its frames. The controls that move."""
        moving = [control for control, numbers, free in self.rig.parts
                  if free and any(abs(pose[n] - self.now[n]) > TINY for pose in self.poses.values() for n in numbers)]
        rules = keys.Rules(scene).for_all()
        for frame, pose in self.poses.items():
            self.rig.apply(pose)
            keys.insert(moving, rules, frame, self.left)
        scene.frame_set(scene.frame_current, subframe=scene.frame_subframe)
        return moving


def read(rig, lines, rest, view):
    """The pose that one drawing shows, and how many of its lines say nothing. Raises library.Error. The character stays."""
    character = rig.character.copy()
    px = [[view.project(rig.mesh.space.from_world(line)) for line in part] for part in (lines, rest)]
    told = character.draw_face(px[0], view, px[1])
    return character.pose, sum(line.curve is None for line in told.lines)


class _FromPencil:
    """Wants a viewport, a Grease Pencil and a mesh."""
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        if context.area is None or context.area.type != 'VIEW_3D':
            cls.poll_message_set('Drawings are read as a 3D Viewport sees them')
        elif pencil_of(context) is None:
            cls.poll_message_set('There is no Grease Pencil to read')
        elif target_mesh(context) is None:
            cls.poll_message_set('Select the mesh beside the Grease Pencil')
        else:
            return True
        return False


def _seen(context, obj):
    region = next(r for r in context.area.regions if r.type == 'WINDOW')
    return seen_in(region, context.space_data.region_3d, obj)


class PENPOSE_OT_pencil_pose(_FromPencil, bpy.types.Operator):
    """Pose the face as the drawing on this frame shows it: all strokes of Grease Pencil that are seen"""
    bl_idname = 'penpose.pencil_pose'
    bl_label = 'Pose from Drawing'

    def execute(self, context):
        obj, pencil = target_mesh(context), pencil_of(context)
        try:
            lines, rest = shown_on_frame(pencil, context.scene.frame_current)
            rig, view = drawing.known(obj, wholly=True).rig, _seen(context, obj).view
            rig.take_pose()
            before = rig.pose()
            pose, unknown = read(rig, lines, rest, view)
            rig.apply(pose)
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        moved, said = rig.moved_from(before), []
        tell_moved(self, obj, moved, keys.key(moved, said=said))
        for line in said:
            self.report({'WARNING'}, line)
        _tell_unknown(self, unknown, pencil)
        return {'FINISHED'}


def _tell_unknown(operator, unknown, pencil):
    if unknown:
        operator.report({'INFO'}, '%d line%s of %s %s taken for no feature of the face' % (
            unknown, 's' if unknown > 1 else '', pencil.name, 'were' if unknown > 1 else 'was'))


class PENPOSE_OT_pencil_film(_FromPencil, bpy.types.Operator):
    """Key a pose on each frame that has a drawing by Grease Pencil. The frames between are left to Blender"""
    bl_idname = 'penpose.pencil_film'
    bl_label = 'Animate from Drawings'

    def _begin(self, context):
        obj, self.pencil = target_mesh(context), pencil_of(context).name
        try:
            self.film = Film(obj, pencil_of(context), _seen(context, obj))
        except (Refused, Error) as problem:
            self.report({'ERROR'}, str(problem))
            return False
        return True

    def _end(self, context):
        try:
            moved = self.film.key(context.scene)
        except (Refused, Error, ReferenceError) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        for line in dict.fromkeys(self.film.left):
            self.report({'WARNING'}, line)
        if not moved:
            self.report({'WARNING'}, 'nothing moves in the drawings of %s, so that nothing is keyed' % self.pencil)
            return {'CANCELLED'}
        self.report({'INFO'}, '%d of %d drawings keyed, %d controls move' % (len(self.film.poses), self.film.count, len(moved)))
        return {'FINISHED'}

    def execute(self, context):
        if not self._begin(context):
            return {'CANCELLED'}
        while self.film.step():
            pass
        return self._end(context)

    def invoke(self, context, event):
        if not self._begin(context):
            return {'CANCELLED'}
        manager = context.window_manager
        self.timer = manager.event_timer_add(0.001, window=context.window)
        manager.progress_begin(0, self.film.count)
        begin(self)
        manager.modal_handler_add(self)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        if not running(self):
            return {'CANCELLED'}
        if event.type == 'ESC':
            self.leave()
            self.report({'INFO'}, 'given up; nothing is keyed')
            return {'CANCELLED'}
        if event.type != 'TIMER':
            return {'RUNNING_MODAL'}
        done = self.film.count - len(self.film.waiting)
        context.workspace.status_text_set('Drawing %d of %d is read. Esc: give up, nothing is keyed' % (done + 1, self.film.count))
        context.window_manager.progress_update(done)
        if self.film.step():
            return {'RUNNING_MODAL'}
        self.leave()
        out = self._end(context)
        redraw()
        return out

    def cancel(self, context):
        self.leave()

    def leave(self):
        """Reads no more; nothing was changed."""
        if running(self):
            bpy.context.window_manager.event_timer_remove(self.timer)
            bpy.context.window_manager.progress_end()
            ended(self)


CLASSES = (PENPOSE_OT_pencil_pose, PENPOSE_OT_pencil_film)
