"""blender -b -P looks_blender.py -- OUT MODEL...: draws the head of each model with Workbench and Eevee as Blender first shows it, from
OUT/NAME_camera.json: OUT/NAME_workbench.png, OUT/NAME_eevee.png. Eevee needs a display."""

import json
import math
import pathlib
import shutil
import sys
import tempfile

import bpy
import mathutils
import numpy

SIDE = 512  # px
numpy.bool = bool  # Debian's importer is older than its numpy


def to_blender(p):
    return mathutils.Vector((p[0], -p[2], p[1]))


def draw(out, model):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / (model.stem + ".glb")  # a VRM is one
        shutil.copy(model, copy)
        bpy.ops.import_scene.gltf(filepath=str(copy))
    for thing in bpy.data.objects:
        if thing.name.startswith("Icosphere"):  # the shape of bones
            thing.hide_render = True
    scene = bpy.context.scene
    seen = json.loads((out / f"{model.stem}_camera.json").read_text())
    eye, middle = to_blender(seen["eye"]), to_blender(seen["look_at"])
    lens = bpy.data.cameras.new("camera")
    lens.angle = math.radians(seen["vertical_fov_degrees"])
    lens.clip_start, lens.clip_end = 0.01 * (eye - middle).length, 20 * (eye - middle).length
    camera = bpy.data.objects.new("camera", lens)
    camera.location = eye
    camera.rotation_euler = (eye - middle).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy = 2.5
    back = (eye - middle).normalized()
    right = mathutils.Vector((0, 0, 1)).cross(back).normalized()
    sun.rotation_euler = (0.72 * back - 0.5 * right + mathutils.Vector((0, 0, 0.62))).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.25, 0.26, 0.28, 1)
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x = scene.render.resolution_y = SIDE
    shading = scene.display.shading
    shading.light, shading.color_type = "STUDIO", "TEXTURE"
    shading.show_cavity = True
    scene.eevee.use_gtao = True
    for engine, name in (("BLENDER_WORKBENCH", "workbench"), ("BLENDER_EEVEE", "eevee")):
        scene.render.engine = engine
        scene.render.filepath = str(out / f"{model.stem}_{name}.png")
        bpy.ops.render.render(write_still=True)


arguments = [pathlib.Path(a) for a in sys.argv[sys.argv.index("--") + 1:]]
for one in arguments[1:]:
    draw(arguments[0], one)
