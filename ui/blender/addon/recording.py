"""What is drawn as a session that penpose replays to the same bits: the model goes along."""
import os

import bpy
from bpy.props import StringProperty
from bpy_extras.io_utils import ExportHelper

from . import drawing, versions
from .controls import Refused
from .library import Error

_records = {}  # folder and name of the session, by the uid of the character's first mesh


def recorded(obj):
    """The path that the drawing on an object is recorded into, or None."""
    return _records.get(_key(obj)) if obj is not None and obj.type == 'MESH' else None


def _key(obj):
    return versions.uid(drawing.parts(obj)[0])


def begin(obj, path):
    """Records from now on: writes the model beside the session, which is written anew after each stroke."""
    one = drawing.known(obj)
    if one.rig.measured:
        raise Refused('%s is moved by %s, which a model file does not hold; bake them, or draw without a record' % (
            obj.name, one.rig.measured))
    stem = os.path.splitext(path)[0]
    model = stem + '.glb'
    if os.path.exists(model) and not os.path.exists(stem + '.session'):
        raise Refused('%s is there already, and the model of the record would take its place; choose another name' % model)
    with open(model, 'wb') as f:
        f.write(drawing.become_its_file(obj))
    one.rig.character.record(os.path.basename(model))
    _records[_key(obj)] = stem + '.session'
    note(obj)


def note(obj):
    """Writes down what was drawn."""
    path = recorded(obj)
    if path is None:
        return
    one = drawing.known(obj)
    try:
        text = one.rig.character.recorded
    except Error:
        # The rig was read again: what is recorded from here on is another session.
        _records.pop(_key(obj))
        raise Refused('the rig of %s changed, so that its record ended; %s holds what was drawn until then' % (obj.name, path)) from None
    with open(path + '.new', 'wb') as f:
        f.write(text)
    os.replace(path + '.new', path)


def end(obj):
    """Records no more."""
    return _records.pop(_key(obj), None)


def end_all():
    """Records nothing more."""
    _records.clear()


class PENPOSE_OT_record(bpy.types.Operator, ExportHelper):
    """Record what is drawn on the object as a session that penpose replays; the model is written beside it"""
    bl_idname = 'penpose.record'
    bl_label = 'Record a Session'

    filename_ext = '.session'
    filter_glob: StringProperty(default='*.session', options={'HIDDEN'})

    @classmethod
    def poll(cls, context):
        from .pen import why_not
        problem = why_not(context)
        if problem:
            cls.poll_message_set(problem)
        return not problem

    def execute(self, context):
        from .pen import mesh_of
        try:
            begin(mesh_of(context), self.filepath)
        except (Refused, Error, OSError) as problem:
            self.report({'ERROR'}, str(problem))
            return {'CANCELLED'}
        return {'FINISHED'}


class PENPOSE_OT_record_end(bpy.types.Operator):
    """End the record; the session and its model stay where they were written"""
    bl_idname = 'penpose.record_end'
    bl_label = 'End the Record'

    @classmethod
    def poll(cls, context):
        from .pen import mesh_of
        return recorded(mesh_of(context)) is not None

    def execute(self, context):
        from .pen import mesh_of
        self.report({'INFO'}, 'the session is %s' % end(mesh_of(context)))
        return {'FINISHED'}


CLASSES = (PENPOSE_OT_record, PENPOSE_OT_record_end)
