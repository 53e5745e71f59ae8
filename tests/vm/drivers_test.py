#!/usr/bin/env python3
"""Keys, rings, strips, wheels and fingers of every kind of tablet that Linux's wacom driver knows: reports of any content are
given to the driver in a virtual machine and to `penpose decode` here, and what both say is compared report by report.

usage: drivers_test.py --penpose PROGRAM --tools FOLDER --work FOLDER [--only PART_OF_A_NAME,...] [--rows FOLDER of an earlier run]
Exit status 77 where there is no virtual machine to be had."""
import argparse
import csv
import os
import subprocess
import sys
import unittest

import machine
import random_hands

# Linux's names (input-event-codes.h) of the codes of keys, as `penpose decode --pad` prints them.
KEYS = {148: 'KEY_PROG1', 149: 'KEY_PROG2', 202: 'KEY_PROG3', 0x110: 'BTN_LEFT', 0x111: 'BTN_RIGHT', 0x115: 'BTN_FORWARD', 0x116: 'BTN_BACK',
        0x126: 'BTN_BASE', 0x127: 'BTN_BASE2', 0x130: 'BTN_A', 0x131: 'BTN_B', 0x132: 'BTN_C', 0x133: 'BTN_X', 0x134: 'BTN_Y', 0x135: 'BTN_Z',
        0x240: 'KEY_BUTTONCONFIG', 0x243: 'KEY_CONTROLPANEL', 0x278: 'KEY_ONSCREEN_KEYBOARD', **{0x100 + i: f'BTN_{i}' for i in range(10)}}


def kernel_rows(text):
    """{kind: {report: state}}, and whether every report was given."""
    rows, whole = {'pad': {}, 'touch': {}}, False
    for line in text.splitlines():
        words = line.split()
        if words[0] == 'end':
            whole = True
        elif words[0] == 'pad':
            keys = '-' if words[2] == '-' else '+'.join(KEYS.get(int(k), hex(int(k))) for k in words[2].split('+'))
            rows['pad'][int(words[1])] = ([keys] + words[3:7], words[7:9])
        elif words[0] == 'touch':
            rows['touch'][int(words[1])] = sorted(words[2:])
    return rows, whole


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


class Drivers(unittest.TestCase):
    def test_every_kind_of_tablet_is_read_as_the_kernel_reads_it(self):
        rows = 0
        for name in NAMES:
            with self.subTest(name):
                kernel, whole = kernel_rows(ROWS[name])
                self.assertTrue(whole, 'the kernel was not given every report')
                for kind in ('pad', 'touch'):
                    found = differences(kind, kernel[kind], our_rows(OPTIONS.penpose, trace_file(name), kind))
                    rows += len(kernel[kind])
                    print(f'{name:24s} {kind:5s} {len(kernel[kind]):4d} rows, {len(found)} differ', flush=True)
                    self.assertFalse(found, f'{kind}: (report, driver, penpose), the first: {found[:3]}')
        print(f'{len(NAMES)} tablets, {rows} rows', flush=True)


def trace_file(name):
    return os.path.join(OPTIONS.work, name + '.hid')


parser = argparse.ArgumentParser()
for option in ('penpose', 'tools', 'work'):
    parser.add_argument('--' + option, required=True)
parser.add_argument('--only', default='')
parser.add_argument('--rows', default='')
OPTIONS = parser.parse_args()
machine.skip_if_missing()
os.makedirs(OPTIONS.work, exist_ok=True)
TABLETS = {name: tablet for name, tablet in random_hands.all_of_them().items() if not OPTIONS.only or any(o in name for o in OPTIONS.only.split(','))}
NAMES = sorted(TABLETS)
FILES = {'/traces/list': ''.join(f'{name} {TABLETS[name][0]} {i % 8}\n' for i, name in enumerate(NAMES))}
for tablet in NAMES:
    FILES[f'/traces/{tablet}.hid'] = TABLETS[tablet][1]
    with open(trace_file(tablet), 'w', encoding='utf-8') as f:
        f.write(TABLETS[tablet][1])
with open(os.path.join(machine.HERE, 'guest/drivers.sh'), encoding='utf-8') as f:
    FILES['/job.sh'] = f.read()
if not OPTIONS.rows:
    ARCHIVE = machine.build_initramfs(OPTIONS.work, [os.path.join(OPTIONS.tools, 'driver_probe')], FILES)
    VM = machine.Machine(OPTIONS.work, ARCHIVE, limit_s=1500)
    try:
        RESULTS = VM.results()
    finally:
        print(VM.text()[-2000:], flush=True)
        VM.end()
    OPTIONS.rows = OPTIONS.work
    for tablet in NAMES:
        with open(os.path.join(OPTIONS.work, tablet + '.rows'), 'wb') as f:
            f.write(RESULTS[tablet + '.rows'])
ROWS = {}
for tablet in NAMES:
    with open(os.path.join(OPTIONS.rows, tablet + '.rows'), encoding='utf-8') as f:
        ROWS[tablet] = f.read()
unittest.main(argv=sys.argv[:1], verbosity=2)
