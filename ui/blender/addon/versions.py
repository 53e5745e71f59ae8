"""What changed in Blender's interface after 3.4, with the version that changed it. All else of the add-on is the same everywhere."""
import bpy
import gpu

VERSION = bpy.app.version
MANY_CORNERS = 30000  # from which on custom normals make a pen lag


def line_shader():
    """The shader of lines of one colour and of any width. 4.0 took the 3D out of its name."""
    return gpu.shader.from_builtin('POLYLINE_UNIFORM_COLOR' if VERSION >= (4, 0, 0) else '3D_POLYLINE_UNIFORM_COLOR')


def plain_normals(mesh):
    """Leaves custom normals out while a target is drawn: they take Blender four fifths of the time of an evaluation. What
    normals_back() wants. 4.1 reads them where they are asked for, and has no such switch on the mesh."""
    slow = getattr(mesh, 'use_auto_smooth', False) and mesh.has_custom_normals and len(mesh.loops) >= MANY_CORNERS
    if not slow or mesh.library is not None:
        return ''
    mesh.use_auto_smooth = False
    return mesh.name


def normals_back(name):
    """Undoes plain_normals()."""
    mesh = bpy.data.meshes.get(name) if name else None
    if mesh is not None:
        mesh.use_auto_smooth = True


def grease_pencil_strokes(obj):
    """The strokes of the active layer's shown frame: [(layer name, points (n, 3) in the object's space)].

    4.3 replaced the data of Grease Pencil: layers have frames with a drawing, whose points lie in one attribute."""
    layer = obj.data.layers.active
    if layer is None:
        return '', []
    if hasattr(layer, 'info'):  # up to 4.2
        frame = layer.active_frame
        return layer.info, [[tuple(p.co) for p in s.points] for s in frame.strokes] if frame else []
    frame = layer.current_frame()
    return layer.name, [[tuple(p.position) for p in s.points] for s in frame.drawing.strokes] if frame else []


def is_grease_pencil(obj):
    """4.3 calls the type GREASEPENCIL, those before GPENCIL."""
    return obj is not None and obj.type in ('GPENCIL', 'GREASEPENCIL')
