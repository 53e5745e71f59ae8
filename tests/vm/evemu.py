"""Recordings of Linux input devices in the form of evemu-record: what virtual_input plays and `penpose decode` reads."""
from collections import namedtuple

SYN, KEY, REL, ABS, MSC = range(5)
X, Y, RX, Z, WHEEL, PRESSURE, DISTANCE, TILT_X, TILT_Y, ABS_MISC = 0, 1, 3, 2, 8, 24, 25, 26, 27, 40
SLOT, MT_X, MT_Y, TRACKING = 0x2f, 0x35, 0x36, 0x39
BTN_0, BTN_1, PEN, RUBBER, TOUCH, STYLUS, STYLUS2 = 0x100, 0x101, 0x140, 0x141, 0x14a, 0x14b, 0x14c
FINGER = 0x145

WIDTH, HEIGHT = 20967, 15725
State = namedtuple('State', 'x y pressure tilt_x tilt_y distance tip tool button1')


def bits(numbers, size):
    data = bytearray(size)
    for n in numbers:
        data[n // 8] |= 1 << n % 8
    return bytes(data)


def recording(name, ids, keys, absolutes, frames, rels=(), mscs=(), properties=()):
    """absolutes: {code: (minimum, maximum, resolution)}. frames: lists of (type, code, value), a millisecond each."""
    lines = ['# EVEMU 1.3', f'N: {name}', f'I: {ids} 0001', f'P: {bits(properties, 8).hex(" ")}']
    used = [t for t, codes in ((KEY, keys), (REL, rels), (ABS, absolutes), (MSC, mscs)) if codes]
    for kind, numbers, size in ((0, [SYN] + used, 8), (KEY, keys, 96), (REL, rels, 8), (ABS, absolutes, 8), (MSC, mscs, 8)):
        data = bits(numbers, size)
        lines += [f'B: {kind:02x} {data[i:i + 8].hex(" ")}' for i in range(0, size, 8)]
    lines += [f'A: {code:02x} {low} {high} 0 0 {resolution}' for code, (low, high, resolution) in absolutes.items()]
    for i, frame in enumerate(frames):
        time = f'{i // 1000}.{i % 1000 * 1000:06d}'
        lines += [f'E: {time} {t:04x} {c:04x} {v:04d}' for t, c, v in frame + [(SYN, 0, 0)]]
    return '\n'.join(lines) + '\n'


def pen_states(count):
    """Strokes of 190 frames with 10 in the air, every fifth one with the eraser; ends with the tip down."""
    for i in range(count):
        tip = i % 200 >= 10
        eraser = i // 200 % 5 == 4
        yield State(100 + i * 37 % 20000, 50 + i * 23 % 15000, 500 + i % 3000 if tip else 0, i * 11 % 6000 - 3000,
                    3000 - i * 7 % 6000, 0 if tip else 20 - i % 10, tip, 'eraser' if eraser else 'pen', not tip and i % 10 == 5)


def pen(states, name='Board Pen', ids='0018 2d1f 0095'):
    """A digitizer on a bus without HID: all that a pen has, with the number of its tool in every frame."""
    frames = []
    for s in states:
        frames.append([(KEY, PEN, int(s.tool == 'pen')), (KEY, RUBBER, int(s.tool == 'eraser')), (ABS, X, s.x), (ABS, Y, s.y), (ABS, PRESSURE, s.pressure),
                       (ABS, TILT_X, s.tilt_x), (ABS, TILT_Y, s.tilt_y), (ABS, DISTANCE, s.distance), (KEY, TOUCH, int(s.tip)),
                       (KEY, STYLUS, int(s.button1)), (MSC, 0, 0x12345678)])
    return recording(name, ids, [PEN, RUBBER, TOUCH, STYLUS, STYLUS2],
                     {X: (0, WIDTH, 100), Y: (0, HEIGHT, 100), PRESSURE: (0, 4095, 0), DISTANCE: (0, 255, 0), TILT_X: (-9000, 9000, 5730),
                      TILT_Y: (-9000, 9000, 5730)}, frames, mscs=[0])


def drawn_states(lines):
    """The tip on lines, ((x, y), (x, y), frames) in parts of the tablet each, and ten frames in the air before each."""
    for (x0, y0), (x1, y1), frames in lines:
        for i in range(-10, frames):
            part = max(i, 0) / (frames - 1)
            x, y = (round((a + (b - a) * part) * size) for a, b, size in ((x0, x1, WIDTH), (y0, y1, HEIGHT)))
            yield State(x, y, 2000 if i >= 0 else 0, 0, 0, 0 if i >= 0 else 10, i >= 0, 'pen', False)


def leaving_states(count):
    """Strokes of 40 frames, each with 5 in the air before it and 4 behind it, then one in which the pen is away."""
    for i, s in enumerate(pen_states(count)):
        at = i % 50
        tip = 5 <= at < 45
        yield s._replace(pressure=1000 + i if tip else 0, tip=tip, button1=False, tool='away' if at == 49 else 'pen')


def pad():
    """Eight keys one after the other, the ring round, the wheel both ways, and a key that is held at the end."""
    frames = []
    for key in range(8):
        frames += [[(KEY, BTN_0 + key, 1), (ABS, ABS_MISC, 15)], [(KEY, BTN_0 + key, 0), (ABS, ABS_MISC, 0)]]
    for place in range(1, 72):
        frames.append([(ABS, WHEEL, place), (ABS, ABS_MISC, 15)])
    frames.append([(ABS, WHEEL, 0), (ABS, ABS_MISC, 0)])
    frames += [[(REL, 8, 1)], [(REL, 8, 1)], [(REL, 8, -1)]]
    frames.append([(KEY, BTN_1, 1), (ABS, ABS_MISC, 15)])
    return recording('Board Pad', '0018 2d1f 0095', [STYLUS] + [BTN_0 + i for i in range(8)],
                     {X: (0, 1, 0), Y: (0, 1, 0), WHEEL: (0, 71, 0), ABS_MISC: (0, 0, 0)}, frames, rels=[8])


def keyboard():
    """No part of a tablet, but like all input devices among the event devices."""
    return recording('Keyboard', '0011 0001 0001', list(range(1, 128)), {}, [[(KEY, 30, 1)], [(KEY, 30, 0)]])


def fingers():
    """Two fingers apart, one of which lifts before the other."""
    frames = [[(ABS, SLOT, 0), (ABS, TRACKING, 5), (ABS, MT_X, 1000), (ABS, MT_Y, 800), (ABS, SLOT, 1), (ABS, TRACKING, 6), (ABS, MT_X, 1500),
               (ABS, MT_Y, 900), (KEY, TOUCH, 1), (KEY, FINGER, 1)]]
    for i in range(1, 50):
        frames.append([(ABS, SLOT, 0), (ABS, MT_X, 1000 - i), (ABS, SLOT, 1), (ABS, MT_Y, 900 + 3 * i)])
    frames += [[(ABS, SLOT, 0), (ABS, TRACKING, -1)], [(ABS, SLOT, 1), (ABS, TRACKING, -1), (KEY, TOUCH, 0), (KEY, FINGER, 0)]]
    return recording('Board Finger', '0018 2d1f 0095', [TOUCH, FINGER],
                     {X: (0, 4095, 20), Y: (0, 3000, 20), SLOT: (0, 9, 0), MT_X: (0, 4095, 20), MT_Y: (0, 3000, 20), TRACKING: (0, 65535, 0)},
                     frames, properties=[0])
