#!/usr/bin/env python3
"""A pen of 1000 reports a second for a minute on a real kernel: none is lost on its way into a stroke, and how long each takes.
A test of its own because the minute cannot be had in less.

usage: burst_test.py --tools FOLDER --work FOLDER [--seconds SECONDS]
Exit status 77 where there is no virtual machine to be had."""
import json
import sys
import unittest

import machine

RATE = 1000
PERIOD, DOWN = 200, 190  # of so many reports so many are drawn, as pump_probe has it


class Burst(unittest.TestCase):
    def test_no_report_of_a_burst_is_lost(self):
        self.assertEqual(BURST['sent'], OPTIONS.seconds * RATE)
        self.assertEqual(BURST['received'], BURST['sent'])
        self.assertEqual((BURST['wrong'], BURST['overruns']), (0, 0))

    def test_every_report_is_in_its_stroke(self):
        self.assertEqual(BURST['strokes'], BURST['sent'] // PERIOD)
        self.assertEqual(BURST['points'], BURST['sent'] * DOWN // PERIOD)


parser = machine.parser_of('tools', 'work')
parser.add_argument('--seconds', type=int, default=60)
OPTIONS = parser.parse_args()
machine.skip_if_missing()
ARCHIVE = machine.archive_of(OPTIONS, 'burst', ('pump_probe',), {'/burst_seconds': str(OPTIONS.seconds)},
                             'virtio_pci virtio_console hid hid-generic uhid'.split())
RESULTS, _ = machine.ran(OPTIONS, ARCHIVE, limit_s=300 + 3 * OPTIONS.seconds)
print(RESULTS['burst.err'].decode(), RESULTS['burst.json'].decode(), flush=True)
BURST = json.loads(RESULTS['burst.json'])
unittest.main(argv=sys.argv[:1], verbosity=2)
