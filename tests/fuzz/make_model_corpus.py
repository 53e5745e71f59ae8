#!/usr/bin/env python3
"""Makes the first corpus of the model and case file fuzzers: small files of every kind that the readers know.

usage: make_model_corpus.py [CORPUS_FOLDER]
"""
import base64
import json
import pathlib
import struct
import sys

FOLDER = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "corpus")
SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


def save(kind, name, data):
    path = FOLDER / kind / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data if isinstance(data, bytes) else data.encode())


class Gltf:
    """A document with the square; accessor 0 is POSITION, 1 the indices."""

    def __init__(self):
        self.binary = b""
        self.json = {"asset": {"version": "2.0"}, "bufferViews": [], "accessors": [], "scenes": [{"nodes": [0]}]}
        self.accessor("<3f", SQUARE, 5126, "VEC3")
        self.accessor("<H", [(i,) for i in (0, 1, 2, 0, 2, 3)], 5123, "SCALAR")
        self.json["meshes"] = [{"name": "a", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]
        self.json["nodes"] = [{"mesh": 0, "name": "n"}]
        self.attributes = self.json["meshes"][0]["primitives"][0]["attributes"]

    def view(self, data):
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)})
        self.binary += data + b"\0" * (-len(data) % 4)
        return len(self.json["bufferViews"]) - 1

    def accessor(self, form, rows, component, kind, **more):
        view = self.view(b"".join(struct.pack(form, *row) for row in rows))
        self.json["accessors"].append(
            {"bufferView": view, "componentType": component, "count": len(rows), "type": kind, **more})
        return len(self.json["accessors"]) - 1

    def glb(self):
        self.json["buffers"] = [{"byteLength": len(self.binary)}]
        text = json.dumps(self.json).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(self.binary), b"BIN\0") + self.binary
        return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks

    def text(self):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.binary).decode()
        return json.dumps({**self.json, "buffers": [{"byteLength": len(self.binary), "uri": uri}]})


def make_gltf():
    plain = Gltf()
    save("gltf", "square.glb", plain.glb())
    save("gltf", "square.gltf", plain.text())

    morph = Gltf()
    normals = morph.accessor("<3f", [(0, 0, 1)] * 4, 5126, "VEC3")
    morph.attributes["NORMAL"] = normals
    indices = morph.view(struct.pack("<2H", 1, 2))
    values = morph.view(struct.pack("<6f", 0, 0, 1, 0, 0, 2))
    morph.json["accessors"].append({"componentType": 5126, "count": 4, "type": "VEC3", "sparse": {
        "count": 2, "indices": {"bufferView": indices, "componentType": 5123}, "values": {"bufferView": values}}})
    morph.json["accessors"].append({**morph.json["accessors"][-1], "bufferView": 0})
    times = morph.accessor("<f", [(0,), (1,)], 5126, "SCALAR")
    keys = morph.accessor("<f", [(0,), (0,), (1,), (1,)], 5126, "SCALAR")
    morph.json["meshes"][0].update(weights=[0.5, 2], extras={"targetNames": ["up", "down"]})
    morph.json["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": 3, "NORMAL": 3}, {"POSITION": 4}]
    morph.json["animations"] = [{"name": "m", "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
                                 "samplers": [{"input": times, "output": keys, "interpolation": "STEP"}]}]
    morph.json["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.5]}}]
    save("gltf", "morph.glb", morph.glb())

    skin = Gltf()
    skin.attributes["JOINTS_0"] = skin.accessor("<4B", [(0, 1, 0, 0)] * 4, 5121, "VEC4")
    skin.attributes["WEIGHTS_0"] = skin.accessor("<4B", [(255, 0, 0, 0), (100, 155, 0, 0)] * 2, 5121, "VEC4", normalized=True)
    identity = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)
    binds = skin.accessor("<16f", [identity, identity[:12] + (-1, 0, 0, 1)], 5126, "MAT4")
    times = skin.accessor("<f", [(0,), (1,)], 5126, "SCALAR")
    turns = skin.accessor("<4f", [(0, 0, 0, 1), (0, 0, 1, 0)], 5126, "VEC4")
    skin.json["nodes"][0]["skin"] = 0
    skin.json["nodes"] += [{"name": "root", "children": [2], "rotation": [0, 0, 0.6, 0.8]},
                           {"name": "tip", "matrix": [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 1, 0, 0, 1]}]
    skin.json["skins"] = [{"joints": [1, 2], "inverseBindMatrices": binds}]
    skin.json["scenes"][0]["nodes"] = [0, 1]
    skin.json["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}],
                                "samplers": [{"input": times, "output": turns}]}]
    save("gltf", "skin.glb", skin.glb())

    rigid = Gltf()
    rigid.json["nodes"] = [{"mesh": 0, "children": [1, 2]}, {"mesh": 0, "translation": [0, 0, 2], "name": "eye"},
                           {"mesh": 0, "scale": [2, 1, -1]}]
    rigid.json["extras"] = {"penpose": {"version": 1, "curves": [{"name": "c", "points": [[0, 1, 0, 0], [1, 0, 0.5, 0.5]]}]}}
    rigid.json["nodes"][1]["extras"] = {"penpose": {"joint": True, "posable": True, "values": [0.1, 0, 0]}}
    rigid.json["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}, "mode": 5})
    rigid.json["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}, "mode": 0})
    save("gltf", "rigid.glb", rigid.glb())

    avatar = Gltf()
    avatar.json["accessors"].append({"componentType": 5126, "count": 4, "type": "VEC3"})
    avatar.json["meshes"][0]["primitives"][0].update(targets=[{"POSITION": 0}], extras={"targetNames": ["shut"]})
    avatar.json["nodes"] += [{"name": "hips"}, {"name": "head"}]
    avatar.json["nodes"][0]["children"] = [1, 2]
    avatar.json["extensions"] = {"VRM": {
        "humanoid": {"humanBones": [{"bone": "hips", "node": 1}, {"bone": "leftThumbProximal", "node": 2}]},
        "blendShapeMaster": {"blendShapeGroups": [
            {"name": "Blink", "binds": [{"mesh": 0, "index": 0, "weight": 100}, {"mesh": 9, "index": 0}]}]}}}
    save("gltf", "avatar.glb", avatar.glb())

    motion = Gltf()
    del motion.json["meshes"]
    motion.json["nodes"] = [{"name": "hips", "translation": [0, 1, 0], "rotation": [0, 0.6, 0, 0.8], "children": [1]},
                            {"name": "head", "translation": [0, 0.5, 0]}, {"name": "happy"}, {"name": "gaze"}]
    motion.json["scenes"][0]["nodes"] = [0, 2, 3]
    times = motion.accessor("<f", [(0,), (1,)], 5126, "SCALAR", min=[0], max=[1])
    turns = motion.accessor("<4f", [(0, 0, 0, 1), (0, 0, 1, 0)], 5126, "VEC4")
    spline = motion.accessor("<4f", [(0, 0, 0, 0), (0, 0, 0, 1), (0, 0, 1, 0)] * 2, 5126, "VEC4")
    shifts = motion.accessor("<3f", [(0, 1, 0), (1, 0, 0)], 5126, "VEC3")
    motion.json["animations"] = [{"samplers": [
        {"input": times, "output": turns}, {"input": times, "output": spline, "interpolation": "CUBICSPLINE"},
        {"input": times, "output": shifts, "interpolation": "STEP"}],
        "channels": [{"sampler": s, "target": {"node": n, "path": path}}
                     for s, n, path in ((0, 0, "rotation"), (1, 1, "rotation"), (2, 0, "translation"),
                                        (2, 2, "translation"), (0, 3, "rotation"))]}]
    motion.json["extensionsUsed"] = ["VRMC_vrm_animation"]
    motion.json["extensions"] = {"VRMC_vrm_animation": {
        "specVersion": "1.0", "humanoid": {"humanBones": {"hips": {"node": 0}, "head": {"node": 1}}},
        "expressions": {"preset": {"happy": {"node": 2}}, "custom": {"odd": {"node": 99}}}, "lookAt": {"node": 3}}}
    save("gltf", "motion.vrma", motion.glb())


def make_surfaces():
    lines = "".join("v %g %g %g\n" % p for p in SQUARE)
    save("obj", "quad.obj", lines + "f 1 2 3 4\n")
    save("obj", "full.obj", "# c\nmtllib a.mtl\no a\n" + lines + "vn 0 0 1\nvt 0 0\nf 1/1/1 2//1 3/1 -1\nl 1 2\no b\n" + lines +
         "f -4 -3 \\\n-2\ncstype bezier\n")
    save("off", "quad.off", "OFF\n4 1 0\n" + "".join("%g %g %g\n" % p for p in SQUARE) + "4 0 1 2 3\n")
    save("off", "normals.off", "CNOFF # n\n4 2 0\n" + "".join("%g %g %g 0 0 1 255 0 0 255\n" % p for p in SQUARE) +
         "3 0 1 2 7\n2 0 1\n")
    vertex = "element vertex 4\nproperty float x\nproperty double y\nproperty short z\nproperty uchar red\n"
    face = "element face 1\nproperty list uchar int vertex_indices\nelement more 1\nproperty list int8 uint16 l\nend_header\n"
    save("ply", "text.ply", "ply\nformat ascii 1.0\ncomment c\n" + vertex + face +
         "".join("%g %g %d 9\n" % p for p in SQUARE) + "4 0 1 2 3\n2 5 6\n")
    for order, name in (("<", "little"), (">", "big")):
        body = b"".join(struct.pack(order + "fdhB", *p, 9) for p in SQUARE) + struct.pack(order + "B4i", 4, 0, 1, 2, 3)
        save("ply", name + ".ply", f"ply\nformat binary_{name}_endian 1.0\n{vertex}{face}".encode() + body +
             struct.pack(order + "b2H", 2, 5, 6))
    facets = [(0, 1, 2), (0, 2, 3)]
    save("stl", "text.stl", "solid s\n" + "".join(
        "facet normal 0 0 1\nouter loop\n" + "".join("vertex %g %g %g\n" % SQUARE[v] for v in f) + "endloop\nendfacet\n"
        for f in facets) + "endsolid s\n")
    save("stl", "binary.stl", b"\0" * 80 + struct.pack("<I", 2) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *(c for v in f for c in SQUARE[v]), 0) for f in facets))


def make_cases():
    case = {"name": "a", "free": [], "view_yaw_degrees": 30, "weights": {}, "rest_energy": 1, "optimum_energy": 0.5,
            "references": [{"curve": "c", "vertices": [0, 1], "target": [[0, 0, 0], [1, 0, 0.5]]}],
            "constraints": [{"curve": "d", "vertices": [2, 3]}]}
    save("cases", "one.json", json.dumps({"mesh": "m", "cases": [case]}))
    save("cases", "two.json", json.dumps({"cases": [{**case, "free": ["x"], "weights": {"x": 1}}, {**case, "name": "b"}]}))
    save("landmarks", "one.json", json.dumps({"curves": {"a": {"vertices": [1, 2, 3]}, "b": {"vertices": [0, 4]}}}))


make_gltf()
make_surfaces()
make_cases()
