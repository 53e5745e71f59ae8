"""Ways of damaging a file. Each takes bytes and a random.Random and returns other bytes; the same generator gives the same damage."""
import copy
import json
import re
import struct
import zlib

NUMBERS = [b'0', b'-1', b'1', b'1e308', b'-1e308', b'1e-320', b'1e18', b'nan', b'inf', b'-inf', b'2147483647', b'2147483648', b'4294967295',
           b'4294967296', b'9223372036854775807', b'18446744073709551616', b'1e999', b'0.1', b'-0', b'65536', b'1000000', b'3,5', b'0x10', b'']
VALUES = [0, -1, 1, 2, 1e308, -1e308, 1e18, 1e-300, 0.5, 2**31, 2**32, 2**53, 2**63, -2**31, 65536, 1000000, None, True, False, '', 'a', '\x1b[2J\x07', 'x' * 5000,
          '\u202e', '../x', '/dev/zero', '\ud7ff', [], {}, [0], [[]], {'': 0}, [1] * 300, [[0, 0]] * 300]
LONGEST = 1 << 20


def flip(data, r):
    out = bytearray(data)
    for _ in range(r.choice([1, 1, 2, 4, 16, 64])):
        if out:
            out[r.randrange(len(out))] ^= 1 << r.randrange(8)
    return bytes(out)


def set_bytes(data, r):
    out = bytearray(data)
    for _ in range(r.choice([1, 1, 3, 9])):
        if out:
            out[r.randrange(len(out))] = r.choice([0, 1, 0x7f, 0x80, 0xff, 10, 27, 34, 44, 91, 123, r.randrange(256)])
    return bytes(out)


def cut(data, r):
    return data[:r.randrange(len(data) + 1)]


def cut_out(data, r):
    a, b = sorted((r.randrange(len(data) + 1), r.randrange(len(data) + 1)))
    return data[:a] + data[b:]


def put_in(data, r):
    at = r.randrange(len(data) + 1)
    piece = r.choice([b'\0', b'\xff' * 9, b'\n', b'[' * 3000, b'{"a":' * 900, b'"', b'\xef\xbb\xbf', b'\r', b'\xff\xfe', b'%s%n', b' ' * 70000, b'1,' * 9000,
                      bytes(r.randrange(256) for _ in range(r.randrange(40)))])
    return data[:at] + piece + data[at:]


def repeat(data, r):
    a, b = sorted((r.randrange(len(data) + 1), r.randrange(len(data) + 1)))
    piece = data[a:b]
    times = r.choice([1, 2, 10, 100, 1000])
    if len(piece) * times > LONGEST:
        times = 1
    return data[:b] + piece * times + data[b:]


def number(data, r):
    found = list(re.finditer(rb'-?[0-9]+(\.[0-9]+)?([eE][-+]?[0-9]+)?', data[:200000]))
    for match in sorted(r.sample(found, min(len(found), r.choice([1, 1, 2, 5, 40]))), key=lambda m: -m.start()):
        data = data[:match.start()] + r.choice(NUMBERS) + data[match.end():]
    return data


def lines(data, r):
    rows = data.split(b'\n')
    if len(rows) > 20000:
        return cut(data, r)
    for _ in range(r.choice([1, 1, 2, 6])):
        a, b = r.randrange(len(rows)), r.randrange(len(rows))
        what = r.randrange(5)
        if what == 0:
            rows[a], rows[b] = rows[b], rows[a]
        elif what == 1 and len(rows) > 1:
            del rows[a]
        elif what == 2:
            rows.insert(a, rows[b])
        elif what == 3 and len(rows[a]) < 1000:
            rows[a:a] = [rows[a]] * r.choice([3, 30, 300])
        else:
            rows[a] = number(rows[a], r)
    return b'\n'.join(rows)


def all_of(node, path=()):
    yield path
    items = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, value in items:
        yield from all_of(value, path + (key,))


def change(document, r):
    """One change of a JSON document, in place where it can be."""
    paths = list(all_of(document))
    path = r.choice(paths)
    if not path:
        return copy.deepcopy(r.choice(VALUES))
    parent = document
    for key in path[:-1]:
        parent = parent[key]
    key, what = path[-1], r.randrange(6)
    if what <= 1:
        parent[key] = copy.deepcopy(r.choice(VALUES))
    elif what == 2:
        del parent[key]
    elif what == 3:
        other = document
        for part in r.choice(paths):
            other = other[part] if not isinstance(other, (list, dict)) or (isinstance(other, dict) and part in other) or (
                isinstance(other, list) and isinstance(part, int) and part < len(other)) else 0
            if not isinstance(other, (list, dict)):
                break
        parent[key] = json.loads(json.dumps(other))
    elif what == 4 and isinstance(parent, list):
        parent[key:key] = [parent[key]] * r.choice([1, 10, 300])
    elif isinstance(parent[key], (int, float)) and not isinstance(parent[key], bool):
        parent[key] = r.choice([parent[key] + 1, parent[key] - 1, -parent[key], parent[key] * 2, parent[key] * 1e9])
    elif isinstance(parent[key], str):
        parent[key] = r.choice([parent[key] + '\x1b]0;x\x07', parent[key] * 50, parent[key][:-1], '\x00' + parent[key], parent[key] + '\n'])
    else:
        parent[key] = copy.deepcopy(r.choice(VALUES))
    return document


def json_text(data, r):
    try:
        document = json.loads(data)
    except (ValueError, RecursionError):
        return flip(data, r)
    for _ in range(r.choice([1, 1, 2, 5])):
        document = change(document, r)
        if not isinstance(document, (dict, list)):
            break
    text = json.dumps(document, allow_nan=True)
    return text[:LONGEST].encode('utf-8', 'replace')


def glb(data, r):
    """A GLB file whose lengths fit what it holds, so that the damage lies deeper."""
    if len(data) < 20 or data[:4] != b'glTF':
        return json_text(data, r)
    length = struct.unpack_from('<I', data, 12)[0]
    text, rest = data[20:20 + length], data[20 + length:]
    if r.random() < 0.75:
        text = json_text(text, r)
    else:
        rest = rest[:8] + r.choice([flip, set_bytes, floats])(rest[8:], r)
    text += b' ' * (-len(text) % 4)
    return struct.pack('<IIIII', 0x46546c67, 2, 20 + len(text) + len(rest), len(text), 0x4e4f534a) + text + rest


def floats(data, r):
    out = bytearray(data)
    for _ in range(r.choice([1, 4, 40])):
        if len(out) >= 4:
            struct.pack_into('<f', out, 4 * r.randrange(len(out) // 4), r.choice([float('nan'), float('inf'), 1e38, -1e38, 1e-42, 0.0, 1e9]))
    return bytes(out)


def png(data, r):
    """Chunks changed, moved or left out, with sums of control that fit."""
    at, chunks = 8, []
    while at + 12 <= len(data):
        length = struct.unpack_from('>I', data, at)[0]
        chunks.append([data[at + 4:at + 8], data[at + 8:at + 8 + length]])
        at += 12 + length
    if not chunks:
        return flip(data, r)
    which, what = r.randrange(len(chunks)), r.randrange(4)
    if what == 0:
        chunks[which][1] = flip(chunks[which][1], r)
    elif what == 1:
        chunks.insert(r.randrange(len(chunks)), list(chunks[which]))
    elif what == 2 and len(chunks) > 1:
        del chunks[which]
    elif len(chunks[0][1]) >= 13:
        head = bytearray(chunks[0][1])
        struct.pack_into('>I', head, 4 * r.randrange(2), r.choice([0, 1, 3, 64, 8192, 16384, 2**31 - 1, 2**32 - 1]))
        head[8 + r.randrange(5)] = r.choice([0, 1, 2, 3, 4, 6, 8, 16, 255])
        chunks[0][1] = bytes(head)
    return data[:8] + b''.join(struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body)) for kind, body in chunks)


def splice(data, r, others):
    other = r.choice(others)
    return data[:r.randrange(len(data) + 1)] + other[r.randrange(len(other) + 1):]


PLAIN = [flip, set_bytes, cut, cut_out, put_in, repeat]
TEXT = PLAIN + [number, number, lines, lines]


def mutate(data, name, r, others):
    """One to three kinds of damage that suit the file's name."""
    end = name.rsplit('.', 1)[-1]
    ways = {'json': TEXT + [json_text] * 8, 'gltf': TEXT + [json_text] * 10, 'glb': PLAIN + [glb] * 14, 'png': PLAIN + [png] * 5, 'stl': PLAIN + [floats],
            'jsonl': TEXT}.get(end, TEXT)
    for _ in range(r.choice([1, 1, 1, 2, 3])):
        if others and r.random() < 0.05:
            data = splice(data, r, others)
        else:
            data = r.choice(ways)(data, r)
    return data[:4 * LONGEST]
