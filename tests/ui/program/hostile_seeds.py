"""What hostile runs begin with: small files of every kind that the command line reads, and the commands that read them."""
import json
import math
import os
import random
import subprocess
import tempfile

import worst_files

# Files that the commands need beside the one that is damaged; each is small and whole.
CASES = {'cases': [{'name': 'a', 'references': [{'vertices': [0, 1, 2], 'target': [[0, 0, 0.1], [1, 0, 0.2], [2, 0, 0.1]]}]}]}
VIEWED = {'mesh': 'face.glb', 'cases': [{'name': 'b', 'free': ['lift'], 'locked': ['lean'], 'view_yaw_degrees': 10, 'view': [5, 3],
                                         'references': [{'vertices': [0, 1, 2], 'target': [[0, 0, 0.1], [1, 0, 0.2], [2, 0, 0.1]]}],
                                         'constraints': [{'vertices': [4, 5]}], 'weights': {'lift': 0.4}}]}
TRACK = {'fps': 25, 'frames': [{'curves': {'a': [[100 + 10 * i, 100 + k * i] for i in range(5)], 'b': [[100, 200], [150, 210 + k]]}} for k in range(4)]}
MAP = {'format': 'curves', 'curves': [{'track': 'a', 'reference': [0, 1, 2, 3], 'weight': 2, 'anchor': ['b']}, {'track': 'b', 'reference': [30, 31, 32]}],
       'stable': ['b'], 'head': 'drop', 'free': ['lift', 'lean']}
CURVES = {'curves': {'a': {'vertices': [0, 1, 2, 3]}, 'b': {'vertices': [30, 31, 32]}}}
CAMERA = {'eye': [15, 2, 60], 'look_at': [15, 2, 0], 'up': [0, 1, 0], 'vertical_fov_degrees': 30}
LABELS = {'frames': [{'image': name, 'curves': {'m': [[4, 4], [12, 7 + 3 * k], [20, 5 + k]]}} for k, name in enumerate(('a.pgm', 'b.pgm'))],
          'features': [['m']]}
SESSION = ('# penpose session edition=11 program=test\n# penpose model 0c1ed05de4985a1fef6863dc35986e2d path=builtin%3Ahead\n'
           '# penpose do set_key time_s=0\n# penpose do set_time time_s=1\n# penpose do set_key time_s=1\n')
# A tablet whose string tells it from others with its ids, and a stroke of it.
STRINGS = SESSION + 'D: 0\nN: Tablet\nI: 3 256c 006e\n# string 201: "HUION_T173_200101"\n# string 2: "a \\"b\\""\n' + ''.join(
    'E: %.6f 12 08 %02x %02x 60 00 50 e8 03 00 00 00 00\n' % (0.005 * i, 0x81 if 0 < i < 39 else 0x80, 5 * i) for i in range(40))


def ring(x, y, radius, count=16):
    return [[round(x + radius * math.cos(2 * math.pi * i / count), 2), round(y + radius * math.sin(2 * math.pi * i / count), 2)] for i in range(count)]


SKETCH = {'model': 'face.glb', 'viewport': [1000, 1000], 'deformers': [
    {'name': 'up', 'camera': CAMERA, 'general': ring(500, 500, 400), 'specific': ring(500, 500, 200), 'reference': [[450, 500], [500, 500], [550, 500]],
     'target': [[450, 470], [500, 440], [550, 470]], 'mode': 'auto'}]}
CONVERSATION = [
    {'do': 'load', 'model': 'face.glb'}, {'do': 'curve', 'vertices': [0, 1, 2]}, {'do': 'target', 'curve': 1, 'points': [[0, 0, 0.1], [1, 0, 0.2], [2, 0, 0.1]]},
    {'do': 'solve', 'preset': 'exact'}, {'do': 'evaluate', 'parameters': {'lift': 0.5}, 'vertices': [1, 2]}, {'do': 'set', 'parameters': {'lift': 0.25}},
    {'do': 'view', 'yaw': 10, 'width': 800}, {'do': 'perform', 'command': 'set_key time_s=1 name=a'}, {'do': 'state', 'id': 7}, {'do': 'save', 'path': 'saved.glb'}]


def face(path):
    """A bent sheet of 120 vertices with two controls, a joint and an animation."""
    document, binary = worst_files.grid(120)
    count = 120
    views, accessors = document['bufferViews'], document['accessors']

    def add(data, kind, component=5126, number=count, **more):
        nonlocal binary
        views.append({'buffer': 0, 'byteOffset': len(binary), 'byteLength': len(data)})
        accessors.append({'bufferView': len(views) - 1, 'componentType': component, 'count': number, 'type': kind, **more})
        binary += data + b'\0' * (-len(data) % 4)
        return len(accessors) - 1
    pack = worst_files.struct.pack
    moves = [b''.join(pack('<fff', 0, 0, f(i)) for i in range(count)) for f in (lambda i: math.exp(-i % 7), lambda i: 0.2 * (i % 30 < 9))]
    primitive = document['meshes'][0]['primitives'][0]
    primitive['targets'] = [{'POSITION': add(move, 'VEC3')} for move in moves]
    primitive['attributes']['JOINTS_0'] = add(bytes([0, 1, 0, 0]) * count, 'VEC4', 5121)
    primitive['attributes']['WEIGHTS_0'] = add(pack('<ffff', 0.5, 0.5, 0, 0) * count, 'VEC4')
    document['meshes'][0].update(weights=[0, 0.25], extras={'targetNames': ['lift', 'lean']})
    document['nodes'] = [{'mesh': 0, 'skin': 0}, {'name': 'neck', 'children': [2]}, {'name': 'head', 'translation': [0, 1, 0]}]
    document['skins'] = [{'joints': [1, 2]}]
    document['scenes'] = [{'nodes': [0, 1]}]
    times, weights = add(pack('<ff', 0, 1), 'SCALAR', number=2, min=[0], max=[1]), add(pack('<ffff', 0, 0, 1, 0.5), 'SCALAR', number=4)
    document['animations'] = [{'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'weights'}}], 'samplers': [{'input': times, 'output': weights}]}]
    document['buffers'][0]['byteLength'] = len(binary)
    worst_files.glb(path, document, binary)


def write(path, content):
    if isinstance(content, (dict, list)):
        content = json.dumps(content)
    with open(path, 'wb') as f:
        f.write(content if isinstance(content, bytes) else content.encode())


def helpers(folder):
    """Writes what commands need beside the damaged file."""
    face(os.path.join(folder, 'face.glb'))
    for name, content in (('cases.json', CASES), ('track.json', TRACK), ('map.json', MAP), ('curves.json', CURVES), ('camera.json', CAMERA),
                          ('labels.json', LABELS), ('sketch.json', SKETCH), ('a.session', SESSION), ('strings.session', STRINGS)):
        write(os.path.join(folder, name), content)
    r = random.Random(1)
    for name in ('a.pgm', 'b.pgm'):
        write(os.path.join(folder, name), b'P5\n24 24\n255\n' + bytes(r.randrange(40, 200) for _ in range(576)))


MODEL = [['info', '{x}'], ['info', '{x}', '--json'], ['convert', '{x}', '{out}.glb'], ['convert', '{x}', '{out}.obj'], ['convert', '{x}', '{out}.csv'],
         ['pose', '{x}', '--cases', 'cases.json', '-o', '{out}.glb', '--json'], ['pose', '{x}', '--cases', 'cases.json', '--preset', 'exact'],
         ['render', '{x}', '--size', '48x48', '-o', '{out}.png'], ['render', '{x}', '--size', '32x32', '--time', '0.5', '--wireframe', '--curves', '-o', '{out}.png'],
         ['articulate', '{x}', '--sketch', 'sketch.json', '-o', '{out}.glb'],
         ['animate', '{x}', '--track', 'track.json', '--map', 'map.json', '-o', '{out}.glb', '--json'],
         ['suggest', '{x}', '--set', 'lift=0.5', '-o', '{out}.glb', '--json'], ['suggest', '{x}', '--leave-one-out'],
         ['replay', 'pen.hid', '--model', '{x}', '-o', '{out}.glb', '--json'], ['convert', 'face.glb', '--shapes', '{x}', '{out}.glb'],
         ['suggest', 'face.glb', '--keys', '{x}', '--set', 'lift=0.5']]


def animate(*more):
    return ['animate', 'face.glb', '--track', '{x}', '--map', 'map.json', '-o', '{out}.glb'] + list(more)


def animate_by(format_name):
    return [['animate', 'builtin:head', '--track', '{x}', '--map', format_name, '-o', '{out}.glb', '--json'],
            ['animate', 'face.glb', '--track', '{x}', '-o', '{out}.glb'], ['animate', 'builtin:head', '--track', '{x}', '--units', '-o', '{out}.glb']]


SESSIONS = [['replay', '{x}'], ['replay', '{x}', '-o', '{out}.glb', '--json'], ['replay', '{x}', '--session', '{out}.session', '--model', 'builtin:head'],
            ['replay', '{x}', '--model', 'face.glb', '-o', '{out}.glb'],
            ['replay', '{x}', '--model', 'face.glb', '--json', '--stroke', '1'], ['suggest', '{x}', '--set', 'jaw=0.2'],
            ['replay', '{x}', '--png', '{out}.png', '--model', 'builtin:head']]
DECODES = [['decode', '{x}'], ['decode', '{x}', '--json'], ['decode', '{x}', '--pad'], ['decode', '{x}', '--touch', '--json'],
           ['decode', '{x}', '--protocol', 'wacom_intuos']]

# kind -> folders of the corpora that it begins with (or files below tests/data), and commands that read it
KINDS = {
    'model': (['gltf', 'obj', 'ply', 'stl', 'off'], MODEL), 'face': (['+face.glb'], MODEL), 'project': (['project', '+data/models', '+data/projects'], MODEL),
    'cases': (['cases', 'pose', '+cases.json', '+viewed.json'],
              [['pose', 'face.glb', '--cases', '{x}', '--json'], ['pose', 'face.glb', '--cases', '{x}', '--form', 'drawn', '--free', 'case'],
               ['render', 'face.glb', '--size', '32x32', '--cases', '{x}', '--case', 'a', '-o', '{out}.png']]),
    'sketch': (['sketch_file', '+sketch.json'], [['articulate', 'face.glb', '--sketch', '{x}', '-o', '{out}.glb', '--json'],
                                                 ['articulate', 'face.glb', '--sketch', '{x}', '-o', '{out}.glb', '--preset', 'paper']]),
    'camera': (['camera_file', '+camera.json'], [['render', 'face.glb', '--size', '32x32', '--camera', '{x}', '-o', '{out}.png']]),
    'curve_track': (['curve_track', '+track.json'], [animate(), animate('--json', '--smooth', '0.2'), animate('--fps', '100', '--tremor', '5'),
                                                     ['animate', 'builtin:demo', '--track', '{x}', '-o', '{out}.glb']]),
    'map': (['map_file', '+map.json'], [['animate', 'face.glb', '--track', 'track.json', '--map', '{x}', '-o', '{out}.glb']]),
    'curves': (['landmarks', '+curves.json'],
               [['animate', 'face.glb', '--track', 'track.json', '--map', 'map.json', '--curves', '{x}', '-o', '{out}.glb']]),
    'openface': (['openface_track'], animate_by('openface')), 'ibug': (['ibug_track'], animate_by('ibug68')), 'arkit': (['arkit_track'], animate_by('arkit')),
    'mediapipe': (['mediapipe_csv', 'mediapipe_json'],
                  animate_by('mediapipe') + [['animate', 'builtin:head', '--track', '{x}', '--picture', '640x480', '-o', '{out}.glb']]),
    'labels': (['+labels.json'], [['track', 'a.pgm', '--labels', '{x}', '-o', '{out}.json']]),
    'picture': (['pgm', 'png', '+a.pgm'], [['track', '{x}', '--labels', 'labels.json', '-o', '{out}.json']]),
    'session': (['session', '+data/sessions', '+a.session', '+strings.session', '+drawn.session'], SESSIONS),
    'capture': (['usbmon'], DECODES + [['replay', '{x}', '--model', 'face.glb', '-o', '{out}.glb']]),
    'recording': (['recording', 'evemu', 'usbhid_dump', 'tablet_debugger'], DECODES + [['replay', '{x}', '--model', 'face.glb', '-o', '{out}.glb']]),
    'trace': (['trace', '+data/traces'], DECODES + [['replay', '{x}', '--model', 'face.glb', '-o', '{out}.glb']]),
    'tablets': (['tablet_file'], [['devices', '--known', '--json', '--tablets', '{x}'], ['devices', '--udev-rule', '--tablets', '{x}'],
                                  ['devices', '--json', '--tablets', '{x}'], ['decode', 'pen.hid', '--tablets', '{x}']]),
    'serve': (['+serve'], [['serve'], ['serve', '--session', '{out}.session']]),
}


def load(root, penpose):
    """kind -> [(name, bytes)], from the corpora in `root`/fuzz/corpus, files in `root`/data and the helpers above, which count thrice."""
    found = {}
    endings = {'cases': '.json', 'session': '.session', 'trace': '.hid', 'serve': '.jsonl', 'tablets': '.json'}
    with tempfile.TemporaryDirectory() as folder:
        helpers(folder)
        write(os.path.join(folder, 'viewed.json'), VIEWED)
        talk = '\n'.join(json.dumps(line) for line in CONVERSATION)
        subprocess.run([penpose, 'serve', '--session', 'drawn.session'], cwd=folder, input=talk.encode(), stdout=subprocess.DEVNULL, check=True)
        for command in (['convert', 'face.glb', 'face.obj'], ['articulate', 'face.glb', '--sketch', 'sketch.json', '-o', 'rigged.glb'],
                        ['animate', 'face.glb', '--track', 'track.json', '--map', 'map.json', '-o', 'clip.glb']):
            subprocess.run([penpose] + command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
        for kind, (places, _) in KINDS.items():
            files = []
            for place in places:
                path = os.path.join(root, 'fuzz/corpus', place)
                if place == '+serve':
                    files.append(('talk.jsonl', talk.encode()))
                    continue
                if place.startswith('+'):
                    path = os.path.join(root, place[1:]) if place.startswith('+data') else os.path.join(folder, place[1:])
                names = [''] if os.path.isfile(path) else sorted(n for n in os.listdir(path) if os.path.isfile(os.path.join(path, n)))
                for name in names:
                    with open(os.path.join(path, name) if name else path, 'rb') as f:
                        content = f.read()
                    name = name or os.path.basename(path)
                    if len(content) < 200000 and not name.endswith('.md'):
                        files += [(name if '.' in name else name + endings.get(kind, ''), content)] * (3 if place.startswith('+') else 1)
            found[kind] = files
    return found
