"""Which controls may move where the user limits them to what is selected, and what of a linked character can be overridden."""
import contextlib

import bpy

from . import curves, versions
from .character import armature_of, largest_of
from .controls import KeyControl, Refused


_among = []  # what chosen() says while among() is in force


@contextlib.contextmanager
def among(controls):
    """Only these keys and bones may move, whatever is selected."""
    plain = [getattr(control, 'control', control) for control in controls]
    bones = {(of.object, of.bone) for of in (getattr(c, 'turn', None) or getattr(c, 'of_bone', None) or c for c in plain) if hasattr(of, 'bone') and
             hasattr(of, 'object')}
    _among.append((bones, {control.key for control in plain if isinstance(control, KeyControl)}))
    try:
        yield
    finally:
        _among.pop()


def chosen(obj):
    """What candidates.selected() wants: the pose bones that are selected, or the active shape key; None: all may move."""
    if _among:
        return _among[-1]
    settings = getattr(bpy.context.window_manager, 'penpose', None)
    if not getattr(settings, 'selected_only', False):
        return None
    armatures = [o for o in bpy.context.view_layer.objects if o.type == 'ARMATURE' and o.mode == 'POSE']
    bones = {(a.name, b.name) for a in armatures for b in a.pose.bones if versions.bone_selected(b) and versions.bone_seen(a, b)}
    if bones:
        return bones, set()
    key = obj.active_shape_key
    if key is None or obj.data.shape_keys is None or key == obj.data.shape_keys.reference_key:
        raise Refused('nothing is selected that may move; select bones in Pose mode or a shape key of %s, or turn off Selected Only' % obj.name)
    return set(), {key.name}


def character_of(context):
    """The mesh that is drawn on: the active one, or the largest of the character that the active object moves; None."""
    active = context.active_object
    if active is None or active.type == 'MESH':
        return active
    if active.type == 'ARMATURE':
        carried = [o for o in context.view_layer.objects if o.type == 'MESH' and armature_of(o) == active and o.visible_get()]
        selected = [o for o in carried if o.select_get()]
        if selected:
            return selected[0]
    if active.type in ('ARMATURE', 'EMPTY', 'LATTICE'):
        return largest_of(active, context.view_layer)
    return None


def overridable(context):
    """The linked object, or the empty that stands for a linked collection, that Object > Library Override > Make takes; None."""
    active = context.active_object
    if active is None:
        return None
    if active.type == 'EMPTY' and active.instance_type == 'COLLECTION' and active.instance_collection is not None:
        return active if active.instance_collection.library is not None else None
    return active if active.library is not None else None


def _linked_collection(scene, obj):
    """The collection of the scene's own that a linked one lies in, and the linked one, which an object comes with; Nones."""
    for above in (scene.collection, *scene.collection.children_recursive):
        for linked in above.children if above.library is None else ():
            if linked.library is not None and obj in linked.all_objects[:]:
                return above, linked
    return None, None


def make_override(context):
    """Overrides the linked character that is active. Its mesh, active now. Raises Refused."""
    active = overridable(context)
    if active is None:
        raise Refused('what is active is not linked; select the linked character')
    name, before = active.name, set(bpy.data.objects)
    if active.type == 'EMPTY' and active.instance_collection is not None:
        made = active.instance_collection.override_hierarchy_create(context.scene, context.view_layer, reference=active)
        if made is not None and active.name in bpy.data.objects:
            bpy.data.objects.remove(active)
    else:
        above, linked = _linked_collection(context.scene, active)
        made = (linked or active).override_hierarchy_create(context.scene, context.view_layer)
        if made is not None and linked is not None:
            above.children.unlink(linked)  # the override lies beside it
    if made is None:
        raise Refused('%s cannot be overridden; make a library override of its collection (Object > Library Override > Make)' % name)
    fresh = [o for o in bpy.data.objects if o not in before and o.override_library is not None]
    for one in fresh:
        versions.editable_override(one)
    for one in [o for o in fresh if o.type == 'MESH']:
        if one.data.library is not None:
            one.data.override_create(remap_local_usages=True)
    meshes = [o for o in fresh if o.type == 'MESH' and o.visible_get()]
    if not meshes:
        raise Refused('%s has no mesh to draw on' % name)
    obj = max(meshes, key=lambda o: len(o.data.polygons))
    for one in context.selected_objects:
        one.select_set(False)
    obj.select_set(True)
    context.view_layer.objects.active = obj
    curves.forget_parts()
    return obj
