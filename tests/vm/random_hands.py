"""Tablets of every kind that Wacom's driver in the kernel knows keys or fingers of, with reports of any content for them."""
import random

from traces import header

PEN_HEAD, TOUCH_HEAD = '050d 0902 a101', '050d 0905 a101'


def items(text):
    return bytes.fromhex(text.replace(' ', ''))


def report_item(number, length, usage='06 00ff 0901', kind='8102'):
    """A report of `length` bytes, its number among them, without a meaning that the descriptor would tell."""
    count = (length - 1).to_bytes(2, 'little').hex()
    return items(f'85{number:02x} {usage} 1500 26ff00 7508 96{count} {kind}')


def pen_side(*reports):
    return items(PEN_HEAD) + b''.join(report_item(*r) for r in reports) + items('c0')


def touch_side(*reports, screen=False, most=0):
    """Fingers of which the first report has places, so that the driver sees that it is one of fingers, and their size, by which it
    divides."""
    body = items('050d 0904 a101' if screen else TOUCH_HEAD)
    for i, (number, length) in enumerate(reports):
        if i == 0:
            body += items(f'85{number:02x} 050d 0922 a102 0942 1500 2501 7501 9501 8102 9507 8103 0501 26ff0f 46983a 7510 9501 0930 8102 0931 8102 4600 00 c0')
            left = length - 1 - 5
            if left > 0:
                body += items(f'06 00ff 0901 26ff00 7508 95{left:02x} 8102')
        else:
            body += report_item(number, length)
    if most:
        body += items(f'85f0 050d 0955 26ff00 25{most:02x} 7508 9501 b102')
    return body + items('c0')


class Maker:
    """Reports that are mostly like real ones and sometimes not: bytes stay as they were, change in a bit, or are anything."""

    def __init__(self, seed):
        self.draw, self.last = random.Random(seed), {}

    def any(self, interface, number, length, keep=()):
        """keep: {place: values of which one stands there}"""
        old = self.last.get((interface, number, length), bytearray(length))
        new = bytearray(old)
        kind = self.draw.random()
        if kind < 0.25:
            new = bytearray(self.draw.randbytes(length))
        elif kind < 0.35:
            new = bytearray(length)
        else:
            for _ in range(self.draw.randrange(1, 4)):
                new[self.draw.randrange(length)] ^= 1 << self.draw.randrange(8)
        new[0] = number
        for place, values in dict(keep).items():
            new[place] = self.draw.choice(values)
        self.last[(interface, number, length)] = new
        return interface, bytes(new)


def fixed(model, name, interfaces, kinds, bus=3, count=90):
    """A tablet, and `count` reports of it. kinds: (interface, number, length, {place: values}) of which one is drawn each time."""
    maker = Maker(model)
    reports = []
    for _ in range(count):
        interface, number, length, keep = maker.draw.choice(kinds)
        reports.append(maker.any(interface, number, length, keep))
    text = ''.join(header(d, name, f'{bus} 056a {model:04x}', i) for i, d in enumerate(interfaces))
    for i, (number, report) in enumerate(reports):
        text += f'D: {number}\nE: {i // 200}.{i % 200 * 5000:06d} {len(report)} {report.hex(" ")}\n'
    return text


def intuos(model, name, number=12, extra=()):
    side = pen_side((2, 10), (number, 10), *extra)
    # A pen's reports between those of the keys, none of which may touch them.
    return fixed(model, name, [side], [(0, number, 10, {})] * 4 + [(0, 2, 10, {1: (0x80, 0xe0, 0x20, 0xc2)})])


def messages(keys=True, count=7):
    """Numbers of the messages of 64 bytes: fingers mostly, keys where the tablet sends them so, and others."""
    numbers = list(range(2, 18)) * 2 + [128] * 4 * keys + [0, 1, 18, 129]
    return {1: tuple(range(8)), **{2 + 8 * i: numbers for i in range(count)}}


def two_sided(model, name, fixed_pen, touch_kinds, touch_length, pen_kinds=()):
    sides = [fixed_pen, touch_side((2, touch_length))]
    return fixed(model, name, sides, list(touch_kinds) + list(pen_kinds), count=140)


def display(model, name, wide):
    length, at, size, most = (64, 63, 6, 10) if wide else (64, 61, 14, 4)
    keep = {at: (0, 0, 1, 2, 4, 5, 9, 10, 11), **{2 + size * i: (1, 2, 3, 4, 5, 6, 7) for i in range(most)}}
    return fixed(model, name, [touch_side((1, length), screen=True)], [(0, 1, length, keep)], count=140)


def tablet_pc(model, name, kinds, most=0):
    return fixed(model, name, [touch_side(*[(n, l) for _, n, l, _ in kinds], screen=True, most=most)], kinds, count=140)


def many(number, bare):
    size = 7 if bare else 11
    # The number of a finger is of two bytes.
    keep = {2: (0, 0, 1, 2, 3, 5, 6, 8), **{3 + size * i + 1: (1, 2, 3, 4) for i in range(5)},
            **{3 + size * i + 2: (0, 0, 0, 1) for i in range(5)}}
    return (0, number, 3 + 5 * size + 2, keep)


def pro_bluetooth(model, name, count=140):
    """Frames of up to ten fingers, which is as many as it feels; those beyond five come in the next. With more, or a frame that is
    begun before the last one ended, the input layer's packet of 80 values is full and shows what came so far."""
    keep = {1 + 14 * i: (0,) for i in range(7)}
    for i in range(4):
        at = 109 + 43 * i
        keep[at] = (0, 0x80, 0x81, 0x82, 0x83, 0x85, 0x86, 0x8a) if i % 2 == 0 else (0x80,)
        keep.update({at + 1 + 8 * j: (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11) for j in range(5)})
    side = pen_side((0x80, 361), (0x81, 361))
    return fixed(model, name, [side], [(0, 0x80, 361, keep), (0, 0x80, 361, keep), (0, 0x81, 361, keep)], bus=5, count=count)


def remote(model=0x331, name='Wacom Express Key Remote'):
    side = pen_side((0x10, 32), (0x11, 32))
    text = fixed(model, name, [side], [(0, 0x11, 32, {3: (7,), 4: (8,), 5: (9,)})])
    listed = bytes([0x10, 0, 1, 1, 7, 8, 9]) + bytes(25)
    head, rest = text.split('D: 0\nE:', 1)
    return head + f'D: 0\nE: 0.000000 32 {listed.hex(" ")}\nD: 0\nE:' + rest


def all_of_them():
    """{name: (transport, trace)}"""
    made = {}

    def add(name, trace, transport='usb'):
        made[name] = (transport, trace)

    graphire = [(0, 2, 8, {})]
    add('graphire4', fixed(0x15, 'Graphire4', [pen_side((2, 8))], graphire))
    add('graphire_bluetooth', fixed(0x81, 'Graphire BT', [pen_side((3, 9))], [(0, 3, 9, {})], bus=5), 'uhid')
    add('bamboo_first', fixed(0x17, 'Bamboo Fun', [pen_side((2, 9))], [(0, 2, 9, {})]))
    for model in (0xb0, 0xb1, 0xb7, 0xb4, 0x3f, 0xc5, 0xc6):
        add(f'intuos3_{model:x}', intuos(model, 'Intuos3'))
    for model in (0xb8, 0xb9, 0xba, 0xbc):
        add(f'intuos4_{model:x}', intuos(model, 'Intuos4'))
    for model, name in ((0xcc, '21ux2'), (0xfa, '22hd'), (0x5b, '22hdt'), (0xf4, '24hd'), (0xf8, '24hdt'), (0x32a, '27qhd'), (0x32b, '27qhdt'),
                        (0x304, '13hd'), (0x333, '13hdt'), (0x307, 'hybrid'), (0x325, 'companion2'), (0x57, 'dtk2241'), (0x59, 'dth2242')):
        number = 17 if name in ('27qhd', '27qhdt') else 3 if name in ('13hd', '13hdt', 'companion2') else 12
        add(f'cintiq_{name}', intuos(model, name, number))
    # The driver itself fails when a DTU-1031X, which has no keys, sends their report.
    add('dtus_32f', fixed(0x32f, 'DTU', [pen_side((0x11, 11), (0x15, 11))], [(0, 0x11, 11, {})]))
    for model in (0xfb, 0x336, 0x343):
        add(f'dtus_{model:x}', fixed(model, 'DTU', [pen_side((0x11, 11), (0x15, 11))], [(0, 0x15, 11, {}), (0, 0x15, 11, {}), (0, 0x11, 11, {})]))
    pen10 = pen_side((2, 10), (3, 10), (0xc0, 10))
    keys_and_pen = [(0, 3, 10, {}), (0, 3, 10, {}), (0, 2, 10, {1: (0x80, 0xc2, 0xe0)}), (0, 0xc0, 10, {})]
    for model in (0x26, 0x27, 0x28, 0x29, 0x314, 0x315, 0x317):
        add(f'intuos5_{model:x}', two_sided(model, 'Intuos5', pen10, [(1, 2, 64, messages(keys=False))] * 5, 64, keys_and_pen))
    for model in (0xd1, 0xd0, 0xd6):
        add(f'bamboo_two_{model:x}', two_sided(model, 'Bamboo', pen_side((2, 9)), [(1, 2, 20, {})], 20))
    bamboo = [(1, 2, 64, messages())] * 5 + [(0, 2, 10, {}), (0, 0xc0, 10, {})]
    for model in (0xde, 0xdf, 0xdd, 0x302, 0x303, 0x30e, 0x323, 0x33b, 0x33c, 0x33d, 0x33e):
        add(f'bamboo_many_{model:x}', two_sided(model, 'Bamboo 16', pen10, bamboo, 64))
    for model in (0xf6, 0x5d, 0x5e, 0x309, 0x335):
        add(f'display_{model:x}', display(model, 'Display', False))
    add('display_32c', display(0x32c, 'Display', True))
    one = {1: (0, 1, 1, 0xff)}
    add('tablet_pc_93', tablet_pc(0x93, 'TabletPC', [(0, 6, 7, one)]))
    add('tablet_pc_9f', tablet_pc(0x9f, 'TabletPC', [(0, 0x10, 7, one), (0, 6, 7, one)]))
    for model in (0xe2, 0xe3, 0xe6):
        add(f'tablet_pc_{model:x}', tablet_pc(model, 'TabletPC two', [(0, 3, 14, {1: (0, 1, 2, 3)}), (0, 6, 7, one)]))
    add('tablet_pc_ed', tablet_pc(0xed, 'TabletPC', [(0, 6, 7, one)]))
    add('tablet_pc_e5', tablet_pc(0xe5, 'MTScreen', [many(0x0d, False), many(3, False)], most=6))
    for model in (0x100, 0x10d, 0x4004, 0x5000):
        add(f'tablet_pc_{model:x}', tablet_pc(model, 'MTTPC', [many(0x0d, True), many(3, True)], most=6))
    add('intuos4_bluetooth', fixed(0xbd, 'Intuos4 WL', [pen_side((3, 22), (4, 32))],
                                   [(0, 3, 22, {1: (2, 12, 12), 11: (2, 12, 12)}), (0, 4, 32, {1: (2, 12), 11: (12,), 21: (12, 2)})], bus=5), 'uhid')
    for model in (0x360, 0x361, 0x393):
        add(f'pro_bluetooth_{model:x}', pro_bluetooth(model, 'Pro BT'), 'uhid')
    for model in (0x377, 0x379, 0x3c6):
        add(f'small_bluetooth_{model:x}', fixed(model, 'Small BT', [pen_side((0x80, 49), (0x81, 49))], [(0, 0x80, 49, {}), (0, 0x81, 49, {})], bus=5), 'uhid')
    add('remote', remote())
    return made
