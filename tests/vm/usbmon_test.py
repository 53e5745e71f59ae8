#!/usr/bin/env python3
"""Captures of USB requests that a real kernel makes: tablets are plugged into a virtual machine and drawn with while usbmon
captures and `penpose record` reads them, and what `penpose decode` prints of both is compared row by row.

usage: usbmon_test.py --penpose PROGRAM --tools FOLDER --work FOLDER [--keep FOLDER]
Exit status 77 where there is no virtual machine to be had."""
import csv
import io
import json
import os
import subprocess
import sys
import unittest

import machine
import traces

MADE = traces.made()
SENT = {'intuos4': MADE['wacom_intuos4'], 'ink': MADE['ink'], 'hand': MADE['hand'], 'huion': MADE['huion']}


def decode(name, *arguments):
    return subprocess.run([OPTIONS.penpose, 'decode', os.path.join(OPTIONS.work, name), *arguments], capture_output=True, text=True)


class Captures(unittest.TestCase):
    def decoded(self, name, *arguments):
        run = decode(name, *arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ''), name)
        return run.stdout

    def rows(self, name, kind):
        """What the program makes of a recording, row for row: axes and samples without their times. Of several interfaces, the
        order in which their reports were read is that of two readers."""
        out = self.decoded(name, '--csv', *([f'--{kind}'] if kind != 'pen' else []))
        lines = out.splitlines()
        rows = csv.DictReader(io.StringIO('\n'.join(l for l in lines if not l.startswith('#'))))
        left_out = ('time_us', 'report') if len(traces.declared(SENT[name.split('.')[0]])) > 1 else ('time_us',)
        return [l for l in lines if l.startswith('#')], [{k: v for k, v in row.items() if k not in left_out} for row in rows]

    def assert_same(self, name, kind, least):
        captured, recorded = self.rows(name + '.pcap', kind), self.rows(name + '.hid', kind)
        print(f'{name:8s} {kind:5s} {len(recorded[1]):4d} rows', flush=True)
        self.assertGreater(len(recorded[1]), least)
        self.assertEqual(captured, recorded)

    def test_every_row_is_that_of_the_tablets_own_recording(self):
        for name, kind, least in (('intuos4', 'pen', 500), ('ink', 'pen', 500), ('huion', 'pen', 200), ('hand', 'pen', 50),
                                  ('hand', 'pad', 40), ('hand', 'touch', 40)):
            with self.subTest(f'{name}, {kind}'):
                self.assert_same(name, kind, least)

    def test_devices_are_told_from_their_descriptors(self):
        for name in SENT:
            with self.subTest(name):
                captured, recorded = (json.loads(self.decoded(name + kind, '--json'))['devices'] for kind in ('.pcap', '.hid'))
                self.assertGreater(len(recorded), 0)
                self.assertEqual(captured, recorded)

    def test_reports_take_as_long_as_they_took(self):
        captured, recorded = (json.loads(self.decoded('ink' + kind, '--json'))['samples'] for kind in ('.pcap', '.hid'))
        took = [samples[-1]['time_us'] - samples[0]['time_us'] for samples in (captured, recorded)]
        self.assertGreater(took[1], 1e6)
        self.assertLess(abs(took[0] - took[1]), 0.2 * took[1])

    def test_a_capture_that_began_after_plugging_in_says_so(self):
        run = decode('late.pcap', '--csv')
        self.assertIn('does not say which tablet', run.stderr)
        self.assertIn('plug', run.stderr)
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)

    def test_nothing_was_lost(self):
        for name in SENT:
            self.assertEqual(RESULTS[name + '.status'].strip(), b'0')
            self.assertIn(b'packets', RESULTS[name + '.packets'])
            self.assertEqual(RESULTS[name + '.hid'].count(b'\nE:'), SENT[name].count('\nE:'), name)
        self.assertNotIn('GAVE UP', CONSOLE)


parser = machine.parser_of('penpose', 'tools', 'work')
parser.add_argument('--keep')
OPTIONS = parser.parse_args()
machine.skip_if_missing()
FILES = {f'/traces/{name}.hid': text for name, text in SENT.items()}
ARCHIVE = machine.archive_of(OPTIONS, 'usbmon', ('virtual_tablet', 'pump_probe', 'usb_capture'), FILES, machine.MODULES + ['usbmon'])
RESULTS, CONSOLE = machine.ran(OPTIONS, ARCHIVE, limit_s=600)
machine.keep(RESULTS, OPTIONS.work, OPTIONS.keep)
unittest.main(argv=sys.argv[:1], verbosity=2)
