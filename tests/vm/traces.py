"""Traces for the virtual machine, and what is in a trace."""
import random

INK = bytes.fromhex(
    '050d0902a1018507 0920a100 094209440945093c0932 150025017501950581029503 8103'.replace(' ', '') +
    '0501550e65117510 9501a4 09303500467c09267c5e8102 093146000626003c8102b4'.replace(' ', '') +
    '050d093026ff0f8102 65145500 16d8dc262823 35a6455a093d093e95028102c0c0'.replace(' ', ''))
# A Wacom pen interface as they all begin: a boot mouse, then reports of nine bytes that only the driver understands.
WACOM = bytes.fromhex(
    '05010902a1018501 0901a100 0509190129031500250195037501 81029501750581030501093009311581257f750895028106c0c0'.replace(' ', '') +
    '050d0901a1018502a100 06 00ff 0901 1500 26ff00 7508 9509 8102 c0 0901 8502 9501 b102 0901 8503 9501 b102 c0'.replace(' ', ''))
# An Intuos Pro has its pen and its keys on one interface, reports 2 and 3, and its fingers on another.
PRO_PEN = bytes.fromhex('050d0902a101 8502 0920a100 0932150025017501950181029507 8103 75089508 26ff00 0930 8102c0'.replace(' ', '') +
                        '06 00ff 8503 0901 15 00 26ff00 7508 9509 8102 c0'.replace(' ', ''))
PRO_TOUCH = bytes.fromhex('050d0905a101 8502 0922a102 0942150025017501950181029507 8103 050126ff0f 0930 7510 9501 8102 0931 8102 c0'.replace(' ', '') +
                          '06 00ff 0901 26ff00 7508 953a 8102 c0'.replace(' ', ''))
# A UC-Logic pen interface: reports of 12 bytes with id 8.
HUION = bytes.fromhex('06 00ff 0901 a101 8508 7508 950b 1500 26ff00 0901 8102 c0'.replace(' ', ''))


# Reports of ten bytes and a feature report that wakes the tablet up.
PARBLO = bytes.fromhex('06 00ff 0901 a101 8502 7508 1500 26ff00 9509 0901 8102 9501 0901 b102 c0'.replace(' ', ''))


def header(descriptor, name, ids, number=0):
    return f'D: {number}\nR: {len(descriptor)} {descriptor.hex(" ")}\nN: {name}\nP: virtual/input{number}\nI: {ids}\n'


def lines(reports):
    return ''.join(f'E: {i // 200}.{i % 200 * 5000:06d} {len(r)} {r.hex(" ")}\n' for i, r in enumerate(reports))


def ink_reports(count):
    """A pen that draws strokes of 40 reports with 10 in the air between them."""
    for i in range(count):
        tip = i % 50 < 40
        state = 0x10 | (1 if tip else 0)
        values = [(i * 37) % 24188, (i * 23) % 15360, 500 + i % 3000 if tip else 0]
        tilt = [(i * 11) % 9000, -((i * 7) % 9000)]
        yield bytes([7, state]) + b''.join(v.to_bytes(2, 'little') for v in values) + b''.join(v.to_bytes(2, 'little', signed=True) for v in tilt)


def intuos_reports(count):
    """An Intuos pen: it is announced, draws, leaves, and comes again."""
    for i in range(count):
        k = i % 60
        if k == 0:
            yield bytes.fromhex('02c2 8028 1234 5670 2000'.replace(' ', ''))
        elif k == 59:
            yield bytes.fromhex('0280000000000000 0000'.replace(' ', ''))
        else:
            x, y, pressure, tilt = 100 + 83 * i % 20000, 200 + 41 * i % 12000, (k * 30 if 5 < k < 50 else 0), 64
            yield bytes([2, 0xe0 | pressure & 1, x >> 9 & 255, x >> 1 & 255, y >> 9 & 255, y >> 1 & 255, pressure >> 3 & 255,
                         (pressure & 6) << 5 | tilt >> 1, (tilt & 1) << 7 | tilt, 10 << 2 | (x & 1) << 1 | y & 1])


def huion_reports(count):
    for i in range(count):
        tip = i % 50 < 40
        x, y, pressure = (i * 61) % 32000, (i * 47) % 20000, 3000 + i % 1000 if tip else 0
        yield bytes([8, 0x80 | (1 if tip else 0)]) + x.to_bytes(2, 'little') + y.to_bytes(2, 'little') + pressure.to_bytes(2, 'little') + bytes([0, 0, 5, 251])


def garbage_reports(count):
    """Reports under an id of the ink pen and others, of any length up to what the descriptor allows and beyond."""
    draw = random.Random(7)
    for i in range(count):
        yield bytes([7 if i % 3 else draw.randrange(256)]) + draw.randbytes(draw.randrange(0, 40))


def pro_trace():
    """The hands of somebody at an Intuos Pro: keys one after the other, the ring round, two fingers apart, the pen, and a key
    that is still held when the plug is pulled."""
    reports = []

    def pad(keys, ring=-1):
        reports.append((0, bytes([3, 0, 0x80 | ring if ring >= 0 else 0, keys & 1, keys >> 1, 0, 0, 0, 0, 0])))

    def fingers(*places):
        body = bytearray(64)
        body[0], body[1] = 2, len(places)
        for i, (down, x, y) in enumerate(places):
            body[2 + 8 * i:10 + 8 * i] = bytes([2 + i, 0x80 if down else 0, x >> 4, y >> 4, (x & 15) << 4 | y & 15, 0, 0, 0])
        reports.append((1, bytes(body)))

    for key in range(7):
        pad(1 << key)
        pad(0)
    for place in range(30):
        pad(0, (50 + place) % 72)
    pad(0)
    for i in range(40):
        fingers((True, 1000 + 10 * i, 900), (True, 1500 + 30 * i, 1000 + i))
    fingers((False, 0, 0), (False, 0, 0))
    reports += [(0, r) for r in intuos_reports(60)]
    pad(1 << 2)
    lines_, last = [], None
    for i, (number, r) in enumerate(reports):
        if number != last:
            lines_.append(f'D: {number}')
        last = number
        lines_.append(f'E: {i // 200}.{i % 200 * 5000:06d} {len(r)} {r.hex(" ")}')
    name, ids = 'Wacom Intuos Pro S', '3 056a 0314'
    return header(PRO_PEN, name, ids) + header(PRO_TOUCH, name, ids, 1) + '\n'.join(lines_) + '\n'


# The three interfaces of Wacom's wireless receiver, as `lsusb -v` shows them (tests/support/hands/wacom_receiver.h).
RECEIVER = [bytes.fromhex(t.replace(' ', '')) for t in (
    '0601ff 0980 a102 1500 26ff00 8580 7508 951f 8101 0901 8502 9503 b102 0901 8503 950c b102 0901 8504 960201 b102 0901 8505 9501 b102 c0',
    '050d 0901 a101 8502 0900 1500 26ff00 7508 9509 8102 8503 0900 7508 9509 8102 8504 0900 7508 9509 8102 c0',
    '0600ff 0901 a101 8502 0901 1500 26ff00 7508 953f 8102 c0')]
# An Intuos Pro's pen interface with the feature report of its lights.
LIGHTS = PRO_PEN[:-1] + bytes.fromhex('8520 0901 7508 9508 b102 c0'.replace(' ', ''))


def receiver_status(product):
    return bytes([0x80, 1 if product else 0, 0, 0, 0, 20, product >> 8, product & 255]) + bytes(24)


def receiver_trace():
    """The same hands behind the receiver, which says for a while that it hears the tablet and at last that it does not. The kernel
    makes the nodes of the other two interfaces anew when it learns of the tablet."""
    hand = reports_of(pro_trace())
    reports = [(0, receiver_status(0x0314).hex())] * 150
    reports += [(number + 1, r) for number, r in hand]
    reports += [(0, receiver_status(0).hex())] * 3
    head = ''.join(header(d, 'Wacom Wireless Receiver', '3 056a 0084', i) for i, d in enumerate(RECEIVER))
    return head + ''.join(f'D: {n}\nE: {i // 200}.{i % 200 * 5000:06d} {len(r.split())} {r}\n' for i, (n, r) in enumerate(spaced(reports)))


def spaced(reports):
    return [(n, bytes.fromhex(r).hex(' ')) for n, r in reports]


def lights_trace():
    """Three presses of the key in the middle of the ring."""
    press, rest = bytes([3, 0, 0, 1, 0, 0, 0, 0, 0, 0]), bytes([3, 0, 0, 0, 0, 0, 0, 0, 0, 0])
    return header(LIGHTS, 'Wacom Intuos Pro M', '3 056a 0315') + lines([press, rest] * 3)


def made():
    """Every trace that needs no recording of a real tablet, by name."""
    draw = random.Random(3)
    return {
        'ink': header(INK, 'Ink pen', '3 1b96 0021') + lines(ink_reports(600)),
        'wacom_intuos4': header(WACOM, 'Wacom Intuos4 4x6', '3 056a 00b8') + lines(intuos_reports(600)),
        'pulled': header(INK, 'Pulled pen', '3 1b96 0025') + lines(ink_reports(400)),
        'late': header(INK, 'Late pen', '3 1b96 0024') + lines(ink_reports(100)),
        'stalled': header(INK, 'Stalled pen', '3 1b96 0026') + lines(ink_reports(100)),
        'garbage': header(INK, 'Noise pen', '3 1b96 0022') + lines(garbage_reports(400)),
        'garbage_descriptor': header(draw.randbytes(300), 'Nothing', '3 1b96 0023'),
        'parblo': header(PARBLO, 'Parblo A609', '3 0b57 9091') + lines(intuos_reports(200)),
        'huion': header(HUION, 'Huion asleep', '3 256c 006d') + lines(huion_reports(300)),
        'hand': pro_trace(),
        'receiver': receiver_trace(),
        'lights': lights_trace(),
        'uclogic': header(HUION, 'Huion awake', '3 256c 006e') + lines(huion_reports(300)),
    }


def declared(trace):
    """Vendor and product of every interface in order, as "056a 00b8"."""
    return [line.split(' ', 2)[2].lower() for line in trace.splitlines() if line.startswith('I:')]


def only(trace, ids):
    """The trace of the one interface with these ids, with what was said of it."""
    number = declared(trace).index(ids)
    kept, at = [], 0
    for line in trace.splitlines():
        if line.startswith('D:'):
            at = int(line[2:])
            line = 'D: 0'
        elif line.startswith('#'):
            if not line.startswith(f'# {number}:'):
                continue
        if at == number or line.startswith('#'):
            kept.append(line)
    return '\n'.join(kept) + '\n'


def reports_of(trace):
    """[(interface, report in hex), ...] in order."""
    number, reports = 0, []
    for line in trace.splitlines():
        if line.startswith('D:'):
            number = int(line[2:])
        elif line.startswith('E:'):
            words = line.split()
            reports.append((number, ''.join(words[3:])))
    return reports
