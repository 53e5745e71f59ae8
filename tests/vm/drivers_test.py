#!/usr/bin/env python3
"""Keys, rings, strips, wheels and fingers of every kind of tablet that Linux's wacom driver knows: reports of any content are
given to the driver in a virtual machine and to `penpose decode` here, and what both say is compared report by report.

usage: drivers_test.py --penpose PROGRAM --tools FOLDER --work FOLDER [--only PART_OF_A_NAME,...] [--rows FOLDER of an earlier run]
Exit status 77 where there is no virtual machine to be had."""
import os
import sys
import unittest

import machine
import random_hands
from pad_rows import differences, kernel_rows, our_rows


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


parser = machine.parser_of('penpose', 'tools', 'work')
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
if not OPTIONS.rows:
    ARCHIVE = machine.archive_of(OPTIONS, 'drivers', ('driver_probe',), FILES)
    RESULTS, _ = machine.ran(OPTIONS, ARCHIVE, limit_s=1500)
    OPTIONS.rows = OPTIONS.work
    for tablet in NAMES:
        with open(os.path.join(OPTIONS.work, tablet + '.rows'), 'wb') as f:
            f.write(RESULTS[tablet + '.rows'])
ROWS = {}
for tablet in NAMES:
    with open(os.path.join(OPTIONS.rows, tablet + '.rows'), encoding='utf-8') as f:
        ROWS[tablet] = f.read()
unittest.main(argv=sys.argv[:1], verbosity=2)
