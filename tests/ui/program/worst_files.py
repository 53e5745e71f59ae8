"""Files that are the worst of their kind: small, and dear to whoever reads them. Each function writes into a folder and
returns the arguments of the command that reads the file, and the files that count for its size."""
import json
import math
import os
import struct
import zlib


def glb(path, document, binary):
    text = json.dumps(document, separators=(',', ':')).encode()
    text += b' ' * (-len(text) % 4)
    binary += b'\0' * (-len(binary) % 4)
    with open(path, 'wb') as f:
        f.write(struct.pack('<III', 0x46546c67, 2, 28 + len(text) + len(binary)))
        f.write(struct.pack('<II', len(text), 0x4e4f534a) + text + struct.pack('<II', len(binary), 0x004e4942) + binary)


def grid(vertices):
    """A document of a bent strip of 30 vertices a row, and its binary part."""
    positions = b''.join(struct.pack('<fff', i % 30, i // 30, math.sin(i)) for i in range(vertices))
    triangles = b''.join(struct.pack('<III', i, i + 1, i + 30) for i in range(vertices - 31))
    document = {
        'asset': {'version': '2.0'}, 'buffers': [{'byteLength': len(positions) + len(triangles)}],
        'bufferViews': [{'buffer': 0, 'byteLength': len(positions)},
                        {'buffer': 0, 'byteOffset': len(positions), 'byteLength': len(triangles)}],
        'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': vertices, 'type': 'VEC3'},
                      {'bufferView': 1, 'componentType': 5125, 'count': 3 * (vertices - 31), 'type': 'SCALAR'}],
        'meshes': [{'primitives': [{'attributes': {'POSITION': 0}, 'indices': 1}]}],
        'nodes': [{'mesh': 0}], 'scenes': [{'nodes': [0]}], 'scene': 0}
    return document, positions + triangles


def many_targets(folder, count=20000, vertices=260):
    path = os.path.join(folder, 'targets.glb')
    document, binary = grid(vertices)
    document['meshes'][0]['primitives'][0]['targets'] = [{'POSITION': 0}] * count
    glb(path, document, binary)
    return ['info', path], [path]


def many_instances(folder):
    path = os.path.join(folder, 'instances.glb')
    document, binary = grid(2000)
    document['nodes'] = [{'mesh': 0}] * 5000
    document['scenes'][0]['nodes'] = list(range(5000))
    glb(path, document, binary)
    return ['info', path], [path]


def zeros(folder):
    path = os.path.join(folder, 'zeros.glb')
    document, binary = grid(64)
    document['accessors'].append({'componentType': 5126, 'count': 2000000000, 'type': 'VEC3'})
    document['meshes'][0]['primitives'][0]['attributes']['POSITION'] = 2
    glb(path, document, binary)
    return ['info', path], [path]


def one_file_many_buffers(folder, count=20000):
    path, other = os.path.join(folder, 'buffers.gltf'), os.path.join(folder, 'data.bin')
    with open(other, 'wb') as f:
        f.write(b'\0' * 1000000)
    with open(path, 'w') as f:
        json.dump({'asset': {'version': '2.0'}, 'buffers': [{'byteLength': 1000000, 'uri': 'data.bin'}] * count}, f)
    return ['info', path], [path, other]


def nested(folder):
    path = os.path.join(folder, 'nested.gltf')
    with open(path, 'w') as f:
        f.write('{"asset":' + '[' * 1000000 + ']' * 1000000 + '}')
    return ['info', path], [path]


def many_numbers(folder):
    path = os.path.join(folder, 'numbers.gltf')
    with open(path, 'w') as f:
        f.write('{"asset":{"version":"2.0"},"extras":[' + '1,' * 1000000 + '1]}')
    return ['info', path], [path]


def long_line(folder):
    path = os.path.join(folder, 'line.obj')
    with open(path, 'w') as f:
        f.write('v 0 0 0\nv 1 0 0\nv 0 1 0\nf ' + '1 2 3 ' * 400000 + '\n')
    return ['info', path], [path]


def one_fan(folder):
    path = os.path.join(folder, 'fan.obj')
    with open(path, 'w') as f:
        f.write(''.join('v %d %d 0\n' % (i % 7, i) for i in range(3000)))
        f.write(''.join('f 1 %d %d\n' % (i, i + 1) for i in range(2, 3000)) * 20)
    return ['info', path], [path]


def huge_counts(folder):
    path = os.path.join(folder, 'counts.off')
    with open(path, 'w') as f:
        f.write('OFF\n2000000000 2000000000 0\n0 0 0\n')
    return ['info', path], [path]


def picture_header(folder):
    path, labels = os.path.join(folder, 'huge.png'), os.path.join(folder, 'labels.json')
    header = b'IHDR' + struct.pack('>IIBBBBB', 16384, 16384, 8, 6, 0, 0, 0)
    with open(path, 'wb') as f:
        f.write(b'\x89PNG\r\n\x1a\n' + struct.pack('>I', 13) + header + struct.pack('>I', zlib.crc32(header)))
    with open(labels, 'w') as f:
        json.dump({'frames': [{'image': 'huge.png', 'curves': {'a': [[0, 0], [9, 9 + k]]}} for k in range(2)]}, f)
    return ['track', path, '--labels', labels, '-o', os.path.join(folder, 'track.json')], [path, labels]


def picture_bomb(folder):
    path, labels = os.path.join(folder, 'bomb.png'), os.path.join(folder, 'labels.json')

    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    packer = zlib.compressobj(9)
    rows = b''.join(packer.compress(b'\0' * 8193) for _ in range(8192)) + packer.flush()
    with open(path, 'wb') as f:
        f.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', 8192, 8192, 8, 0, 0, 0, 0)) + chunk(b'IDAT', rows) +
                chunk(b'IEND', b''))
    with open(labels, 'w') as f:
        json.dump({'frames': [{'image': 'bomb.png', 'curves': {'a': [[0, 0], [9, 9 + k]]}} for k in range(2)]}, f)
    return ['track', path, '--labels', labels, '-o', os.path.join(folder, 'track.json')], [path, labels]


def textured(path, pictures):
    """A grid in strips of a material each, whose pictures are bytes, or uris where they are text."""
    vertices = 40 + 30 * len(pictures)
    document, binary = grid(vertices)
    del document['accessors'][1]
    document['accessors'].append({'bufferView': 0, 'componentType': 5126, 'count': vertices, 'type': 'VEC2'})
    document['bufferViews'][0]['byteStride'] = 12
    document.update(images=[], textures=[], materials=[], meshes=[{'primitives': []}])
    for i, picture in enumerate(pictures):
        if isinstance(picture, str):
            document['images'].append({'uri': picture})
        else:
            document['bufferViews'].append({'buffer': 0, 'byteOffset': len(binary), 'byteLength': len(picture)})
            document['images'].append({'bufferView': len(document['bufferViews']) - 1, 'mimeType': 'image/png'})
            binary += picture + b'\0' * (-len(picture) % 4)
        document['textures'].append({'source': i})
        document['materials'].append({'pbrMetallicRoughness': {'baseColorTexture': {'index': i}}})
        document['accessors'].append({'bufferView': 1, 'byteOffset': 12 * 30 * i, 'componentType': 5125, 'count': 87, 'type': 'SCALAR'})
        document['meshes'][0]['primitives'].append({'attributes': {'POSITION': 0, 'TEXCOORD_0': 1}, 'indices': 2 + i, 'material': i})
    document['buffers'][0]['byteLength'] = len(binary)
    glb(path, document, binary)


def png(width, height, rows):
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 6, 0, 0, 0)) + chunk(b'IDAT', rows) +
            chunk(b'IEND', b''))


def no_textures(folder):
    """Textures of every kind that cannot be drawn: the model is drawn grey, with one note."""
    path = os.path.join(folder, 'grey.glb')
    whole = png(16, 16, zlib.compress(b'\0' * 16 * 65))
    pictures = [png(16384, 16384, b''), whole[:-20], png(16, 16, b'no stream'), b'\xabKTX 20\xbb\r\n\x1a\n' + b'\0' * 70, b'GIF89a',
                'gone.png', 'grey.glb', '../../etc/passwd', 'data:image/png;base64,AAAA', '']
    textured(path, pictures)
    return ['render', path, '-o', os.path.join(folder, 'grey.png'), '--size', '64x64'], [path]


def texture_bomb(folder):
    path = os.path.join(folder, 'bomb.glb')
    packer = zlib.compressobj(9)
    rows = b''.join(packer.compress(b'\0' * (4 * 8192 + 1)) for _ in range(8192)) + packer.flush()
    textured(path, [png(8192, 8192, rows)] * 4)
    return ['render', path, '-o', os.path.join(folder, 'bomb.png'), '--size', '64x64'], [path]


def many_labels(folder, count=2000):
    path, labels = os.path.join(folder, 'face.png'), os.path.join(folder, 'labels.json')

    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    rows = b''.join(b'\0' + bytes((x * y) % 251 for x in range(40)) for y in range(40))
    with open(path, 'wb') as f:
        f.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', 40, 40, 8, 0, 0, 0, 0)) +
                chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))
    with open(labels, 'w') as f:
        json.dump({'frames': [{'image': 'face.png', 'curves': {'a': [[5, 5], [30, 9 + k % 20]]}} for k in range(count)]}, f)
    return ['track', path, '--labels', labels, '-o', os.path.join(folder, 'track.json')], [path, labels]


def many_keys(folder, count=20000):
    path = os.path.join(folder, 'keys.session')
    with open(path, 'w') as f:
        f.write('# penpose session edition=11 program=test\n# penpose model 0c1ed05de4985a1fef6863dc35986e2d path=builtin%3Ahead\n')
        f.write(''.join('# penpose do set_key time_s=%d\n' % i for i in range(count)))
    return ['replay', path], [path]


def huge_view(folder):
    path = os.path.join(folder, 'view.session')
    camera = 'view 0,0,0.6/0,0,0/0,1,0/20/8192x8192'
    with open(path, 'w') as f:
        f.write('# penpose session edition=11 program=test\n# penpose model 0c1ed05de4985a1fef6863dc35986e2d path=builtin%3Ahead\n'
                '# penpose ' + camera + '\n')
    return ['replay', path, '--png', os.path.join(folder, 'view.png')], [path]


def empty_frames(folder, count=300000):
    path = os.path.join(folder, 'nobody.json')
    face = {'curves': {'brow_R': [[100 + 10 * i, 100] for i in range(5)]}}
    with open(path, 'w') as f:
        f.write('{"fps":25,"frames":[%s,%s%s]}' % (json.dumps(face), 'null,' * count, json.dumps(face)))
    return ['animate', 'builtin:demo', '--track', path, '-o', os.path.join(folder, 'clip.glb')], [path]


def numbered_far_apart(folder):
    points = os.path.join(folder, 'points')
    os.mkdir(points)
    files = []
    for n in range(10):
        files.append(os.path.join(points, 'f%06d.pts' % (n * 100000)))
        with open(files[-1], 'w') as f:
            f.write('version: 1\nn_points: 68\n{\n')
            f.write(''.join('%.3f %.3f\n' % (100 + 9 * math.cos(i) + n, 90 + 8 * math.sin(1.7 * i)) for i in range(68)) + '}\n')
    return ['animate', 'builtin:demo', '--track', points, '-o', os.path.join(folder, 'clip.glb')], files


def many_controls(folder):
    model, cases = os.path.join(folder, 'controls.glb'), os.path.join(folder, 'cases.json')
    document, binary = grid(100)
    document['meshes'][0]['primitives'][0]['targets'] = [{'POSITION': 0}] * 20000
    glb(model, document, binary)
    with open(cases, 'w') as f:
        json.dump({'cases': [{'name': 'a', 'references': [{'vertices': [0, 1, 2], 'target': [[0, 0, 1], [1, 0, 1], [2, 0, 1]]}]}]}, f)
    return ['pose', model, '--cases', cases], [model, cases]


def many_meshes(folder):
    """Small meshes side by side: what is kept of a mesh is far more than its numbers."""
    path = os.path.join(folder, 'meshes.glb')
    document, binary = grid(40)
    document['meshes'] = document['meshes'] * 20000
    document['nodes'] = [{'mesh': i} for i in range(20000)]
    document['scenes'][0]['nodes'] = list(range(20000))
    glb(path, document, binary)
    return ['info', path], [path]


def many_seams(folder, count=45000):
    """Parts whose vertices lie on each other: each is put together by itself."""
    path = os.path.join(folder, 'seams.glb')
    corners = [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)]
    binary = b''.join(struct.pack('<fff', x, y, 0) for x, y in corners)
    document = {
        'asset': {'version': '2.0'}, 'buffers': [{'byteLength': len(binary)}],
        'bufferViews': [{'buffer': 0, 'byteLength': len(binary)}],
        'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': len(corners), 'type': 'VEC3'}],
        'meshes': [{'primitives': [{'attributes': {'POSITION': 0}}]}],
        'nodes': [{'mesh': 0}] * count, 'scenes': [{'nodes': list(range(count))}], 'scene': 0}
    glb(path, document, binary)
    return ['info', path], [path]


def empty_entries(folder, name, count):
    path = os.path.join(folder, name + '.glb')
    document, binary = grid(40)
    document[name] = document.get(name, []) + [{}] * count
    glb(path, document, binary)
    return ['info', path], [path]


def empty_nodes(folder):
    return empty_entries(folder, 'nodes', 300000)


def empty_materials(folder):
    return empty_entries(folder, 'materials', 300000)


def some_materials(folder):
    return empty_entries(folder, 'materials', 8000)


def empty_primitives(folder):
    path = os.path.join(folder, 'primitives.glb')
    document, binary = grid(40)
    document['meshes'][0]['primitives'] += [{'attributes': {}}] * 200000
    glb(path, document, binary)
    return ['info', path], [path]


def fine_lines(folder, count=20000):
    cases = os.path.join(folder, 'fine.json')
    target = [[0.001 * i, round(0.01 * math.sin(i), 6), 0] for i in range(count)]
    with open(cases, 'w') as f:
        json.dump({'cases': [{'name': 'a', 'references': [{'vertices': [i % 9000 for i in range(count)], 'target': target}]}]}, f)
    return ['pose', 'builtin:head', '--cases', cases, '--form', 'drawn'], [cases]


def endless_session(folder):
    path = os.path.join(folder, 'zeros.session')
    with open(path, 'wb') as f:
        f.truncate(1 << 31)
    return ['replay', path], []


def huge_session(folder):
    path = os.path.join(folder, 'huge.session')
    with open(path, 'wb') as f:
        f.truncate(1 << 42)
    return ['decode', path], []


def endless_angle(folder):
    cases = os.path.join(folder, 'angle.json')
    with open(cases, 'w') as f:
        f.write('{"cases": [{"name": "a", "view_yaw_degrees": 1e18, "references": [{"vertices": [0, 1, 2], "target": [[0,0,0],[1,1,1]]}]}]}')
    return ['pose', 'builtin:head', '--cases', cases, '--form', 'drawn'], [cases]


def changing_captures(folder, count=8000):
    """A USB device of 32 interfaces and 32 strings, one of whose report descriptors is another one every time."""
    path = os.path.join(folder, 'changing.pcap')
    packets = []

    def packet(event, transfer, endpoint, setup, data):
        # usbmon's header: URB, event, transfer, endpoint, device, bus, what there is, time, status, length, setup.
        packets.append(struct.pack('<Q4BH2bqiiII8s', 7, ord(event), transfer, endpoint, 5, 1, 0 if setup else 45, 0, 1, 0, 0, len(data), len(data), setup) + data)

    def ask(setup, answer):
        packet('S', 2, 0x80, bytes(setup), b'')
        packet('C', 2, 0x80, b'', answer)

    ask([0x80, 6, 0, 1, 0, 0, 18, 0], bytes([18, 1, 0, 2, 0, 0, 0, 64, 0x6c, 0x25, 0x6d, 0, 0, 1, 1, 2, 0, 1]))
    body = b''.join(bytes([9, 4, i, 0, 1, 3, 0, 0, 0]) for i in range(32)) + bytes([7, 5, 0x81, 3, 64, 0, 1])
    ask([0x80, 6, 0, 2, 0, 0, 255, 255], bytes([9, 2, 0, 0, 32, 1, 0, 0, 0]) + bytes([9, 4, 0, 0, 1, 3, 0, 0, 0, 7, 5, 0x81, 3, 64, 0, 1]) + body)
    for i in range(1, 33):
        ask([0x80, 6, i, 3, 9, 4, 255, 0], bytes([254, 3]) + b'x\0' * 126)
    for i in range(count):
        ask([0x81, 6, 0, 0x22, i % 32, 0, 1, 0], bytes([i // 32 % 2 + 1]))
        packet('C', 1, 0x81, b'', bytes([8, i % 256]))
    with open(path, 'wb') as f:
        f.write(struct.pack('<IHHiIII', 0xa1b2c3d4, 2, 4, 0, 0, 65536, 189))
        f.write(b''.join(struct.pack('<IIII', 1, 0, len(p), len(p)) + p for p in packets))
    return ['decode', path], [path]


ALL = [changing_captures, many_targets, many_instances, many_seams, empty_nodes, empty_materials, some_materials, empty_primitives, zeros, one_file_many_buffers,
       nested, many_numbers, long_line, one_fan, huge_counts, picture_header,
       picture_bomb, many_labels, many_keys, huge_view, empty_frames, numbered_far_apart, many_controls, many_meshes, fine_lines,
       endless_session, huge_session, endless_angle, no_textures, texture_bomb]
