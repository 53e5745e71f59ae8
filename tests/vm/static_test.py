#!/usr/bin/env python3
"""Tablets that the static program reads through hidraw alone, in a machine whose root cannot be written to and that has neither
/dev/shm nor udevd nor a locale: what it recorded beside what was sent.

usage: static_test.py --penpose STATIC_PROGRAM --tools FOLDER --work FOLDER
Exit status 77 where there is no virtual machine to be had."""
import json
import sys
import unittest

import machine
import traces

TABLETS = {'ink': None, 'wacom_intuos4': 'wacom', 'uclogic': 'uclogic', 'hand': 'wacom'}


class Static(machine.LeftBehind):
    def test_nothing_is_plugged_in_at_first(self):
        self.assertEqual(self.text('none.txt').splitlines()[0], 'no tablet is plugged in')

    def test_tablets_are_read_through_hidraw_beside_their_driver(self):
        for name, driver in TABLETS.items():
            with self.subTest(name):
                for tablet in json.loads(self.text(name + '.json'))['tablets']:
                    self.assertEqual((tablet['transport'], tablet['can_open']), ('hidraw', True))
                    if driver:
                        self.assertEqual(tablet['driver'], driver)

    def test_every_report_is_recorded_up_to_the_unplugging(self):
        for name in TABLETS:
            with self.subTest(name):
                self.assertEqual(self.text(name + '.status'), '0', self.text(name + '.err'))
                self.assertIn('was unplugged', self.text(name + '.err'))
                sent, recorded = traces.reports_of(SENT[name]), traces.reports_of(self.text(name + '.hid'))
                self.assertEqual(len(recorded), len(sent))
                # The kernel's driver rewrites those of uclogic; the two interfaces of a tablet are read side by side.
                if name != 'uclogic':
                    for number in {n for n, _ in sent}:
                        self.assertEqual([r for n, r in recorded if n == number], [r for n, r in sent if n == number])

    def test_no_wait_inside_was_in_vain(self):
        self.assertNotIn('GAVE UP', CONSOLE)
        self.assertNotIn('Out of memory', self.text('dmesg.txt'))


OPTIONS = machine.parser_of('penpose', 'tools', 'work').parse_args()
machine.skip_if_missing()
SENT = {name: text for name, text in traces.made().items() if name in TABLETS}
FILES = {f'/traces/{name}.hid': text for name, text in SENT.items()}
ARCHIVE = machine.archive_of(OPTIONS, 'static', ('virtual_tablet',), FILES)
RESULTS, CONSOLE = machine.ran(OPTIONS, ARCHIVE, limit_s=800, processors=2)
Static.results = RESULTS
unittest.main(argv=sys.argv[:1], verbosity=2)
