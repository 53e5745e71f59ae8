"""States of pads and fingers by report, as lines of driver_probe and rows of `penpose decode` say them, compared."""
import csv
import subprocess

# Linux's names (input-event-codes.h) of the codes of keys, as `penpose decode --pad` prints them.
KEYS = {148: 'KEY_PROG1', 149: 'KEY_PROG2', 202: 'KEY_PROG3', 0x110: 'BTN_LEFT', 0x111: 'BTN_RIGHT', 0x115: 'BTN_FORWARD', 0x116: 'BTN_BACK',
        0x126: 'BTN_BASE', 0x127: 'BTN_BASE2', 0x130: 'BTN_A', 0x131: 'BTN_B', 0x132: 'BTN_C', 0x133: 'BTN_X', 0x134: 'BTN_Y', 0x135: 'BTN_Z',
        0x240: 'KEY_BUTTONCONFIG', 0x243: 'KEY_CONTROLPANEL', 0x278: 'KEY_ONSCREEN_KEYBOARD', **{0x100 + i: f'BTN_{i}' for i in range(10)}}


def kernel_rows(text, in_one=False):
    """{kind: {report: state}}, and whether every report was given. in_one: nodes of pads are parts of one pad."""
    rows, whole, parts = {'pad': {}, 'touch': {}}, False, {}
    for line in text.splitlines():
        words = line.split()
        if words[0] == 'end':
            whole = True
        elif words[0] == 'pad':
            keys = '-' if words[2] == '-' else '+'.join(KEYS.get(int(k), hex(int(k))) for k in words[2].split('+'))
            report, state = int(words[1]), ([keys] + words[3:7], words[7:9])
            if in_one:
                parts[words[9]] = state
                turned = rows['pad'].get(report, (0, ['0', '0']))[1]
                state = (together([p[0] for p in parts.values()]), [str(int(a) + int(b)) for a, b in zip(turned, state[1])])
            rows['pad'][report] = state
        elif words[0] == 'touch':
            rows['touch'][int(words[1])] = sorted(words[2:])
    return rows, whole


def together(parts):
    """The keys of all parts, and each axis as the part has it that knows it; 0 before it said anything."""
    keys = [p[0] for p in parts if p[0] != '-']
    return ['+'.join(keys) or '-'] + [next((a for a in axis if a != '-'), '0') for axis in zip(*(p[1:] for p in parts))]


def our_rows(program, trace, kind):
    run = subprocess.run([program, 'decode', trace, '--' + kind, '--csv'], capture_output=True, text=True)
    if run.returncode:
        return {}
    lines = [line for line in run.stdout.splitlines() if not line.startswith('#')]
    rows = {}
    for row in csv.DictReader(lines):
        if kind == 'pad':
            rows[int(row['report'])] = ([row['keys']] + [row[k] or '-' for k in ('ring', 'ring2', 'strip', 'strip2')],
                                        [row['wheel'] or '0', row['hwheel'] or '0'])
        else:
            rows[int(row['report'])] = sorted(row['contacts'].split())
    return rows


def is_idle(kind, state):
    return all(x in ('-', '0') for x in (state[0] if kind == 'pad' else state))


def differences(kind, kernel, ours):
    """Reports after which the two stand at something else; a state holds until the next row."""
    found, theirs, mine = [], None, None
    for at in sorted(set(kernel) | set(ours)):
        theirs, mine = kernel.get(at, theirs), ours.get(at, mine)
        if theirs is None or mine is None:
            same = is_idle(kind, theirs if mine is None else mine)
        elif kind == 'pad':
            same = theirs[0] == mine[0] and kernel.get(at, (0, ['0', '0']))[1] == ours.get(at, (0, ['0', '0']))[1]
        else:
            same = theirs == mine
        if not same:
            found.append((at, theirs, mine))
    return found
