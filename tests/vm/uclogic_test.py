#!/usr/bin/env python3
"""Pads of tablets that the kernel's driver hid-uclogic wakes up and rewrites: keys, ring, strip and dial that `penpose` reads from
hidraw, beside what the driver's own event devices say of the same reports in the same machine.

usage: uclogic_test.py --penpose PROGRAM --tools FOLDER --work FOLDER [--keep FOLDER]
Exit status 77 where there is no virtual machine to be had."""
import json
import os
import random
import sys
import unittest

import machine
from pad_rows import KEYS, differences, kernel_rows, our_rows, together
from traces import header, lines, reports_of

# Interfaces as the tablets have them before the driver rewrites them: one report of a vendor's bytes each.
VENDORS_PEN = {number: bytes.fromhex(f'0600ff 0901 a101 85{number:02x} 7508 95{length - 1:02x} 1500 26ff00 0901 8102 c0'.replace(' ', ''))
               for number, length in ((7, 8), (8, 12), (2, 12))}
MOUSE = bytes.fromhex('05010902a1010901a100050919012903150025019508750181020501093009311581257f750895028106c0c0'.replace(' ', ''))
# USB string 200 of Huion's second protocol: x and y up to 50800 and 31750, pressure up to 8191, 5080 lines an inch. The driver knows
# the model with a ring by all of its bytes.
RING = '70c600067c00ff1fd813030d1001043c3e'
STRIP = '70c600067c00ff1fd81300000000000000'
# String 100 of the first protocol and of UGEE's second: x and y up to 25400 and 15875, 8 keys, with (1) or without a dial, pressure
# up to 8191, 5080 lines an inch.
FIRST = '3863033e0800ff1fd813'
UGEE_DIAL = '3863033e0801ff1fd813'
COUNT = 300


def pen(draw, number, length):
    return bytes([number, 0x80 | draw.randrange(2)]) + draw.randbytes(length - 2)


def huion(seed, kinds):
    """Reports of Huion's second protocol, `kinds` among the pen's: the second byte says what the report is of."""
    draw = random.Random(seed)
    for _ in range(COUNT):
        kind = draw.choice(kinds)
        if kind == 'keys':
            yield bytes([8, 0xe0, 1, 1]) + few_keys(draw) + bytes(5)
        elif kind == 'touch':
            yield bytes([8, 0xf0, 1, 1, 0, draw.choice((0, draw.randrange(1, 13), draw.randrange(1, 9)))]) + bytes(6)
        elif kind == 'dial':
            yield bytes([8, 0xf1, 1, 1, 0, draw.choice((0, 1, 2))]) + bytes(6)
        else:
            yield pen(draw, 8, 12)


def few_keys(draw):
    """Three bytes of keys, of which few or none are held."""
    keys = 0
    for _ in range(draw.randrange(3)):
        keys |= 1 << draw.randrange(20)
    return keys.to_bytes(3, 'little')


def first(seed):
    draw = random.Random(seed)
    for _ in range(COUNT):
        yield bytes([7, 0xe0, 1, 1]) + few_keys(draw) + bytes(1) if draw.random() < 0.7 else pen(draw, 7, 8)


def ugee(seed):
    draw = random.Random(seed)
    for _ in range(COUNT):
        if draw.random() < 0.8:
            yield bytes([2, 0xf0, draw.choice((0, 1 << draw.randrange(8))), 0, 0, 0, 0, draw.choice((0, 1, 2))]) + bytes(4)
        else:
            yield pen(draw, 2, 12)


def trace(name, ids, number, reports):
    return header(VENDORS_PEN[number], name, ids) + lines(reports)


def ugee_trace():
    """The pen is on the third interface."""
    interfaces = ''.join(header(d, 'XP-PEN dial', '3 28bd 0909', i) for i, d in enumerate((MOUSE, MOUSE, VENDORS_PEN[2])))
    return interfaces + 'D: 2\n' + lines(ugee(4))


# name: (trace, options of the virtual device)
TABLETS = {
    'ring': (trace('Huion ring', '3 256c 006e', 8, huion(1, ('keys', 'touch', 'pen'))), f'0 --string 201=HUION_T173_200101 --bytes 200={RING}'),
    'strip': (trace('Huion strip', '3 256c 006d', 8, huion(2, ('keys', 'touch', 'touch', 'pen'))),
              f'1 --string 201=HUION_T173_200101 --bytes 200={STRIP}'),
    'dial': (trace('Huion dial', '3 256c 006d', 8, huion(3, ('keys', 'dial', 'dial', 'pen'))),
             f'2 --string 201=HUION_T173_200101 --bytes 200={STRIP}'),
    'first': (trace('Huion first', '3 256c 006e', 7, first(5)), f'3 --string 201=HUION_T153_160607 --bytes 100={FIRST} --bytes 123=48004b0020004f006e00'),
    'ugee': (ugee_trace(), f'4 --output yes --bytes 100={UGEE_DIAL}'),
}


class Pads(machine.LeftBehind):
    def test_the_kernels_driver_has_them_and_hidraw_is_read(self):
        for name in TABLETS:
            with self.subTest(name):
                tablet, = [t for t in json.loads(self.text(name + '.json'))['tablets'] if t['carries'] == 'pen']
                self.assertEqual((tablet['driver'], tablet['transport'], tablet['keys']), ('uclogic', 'hidraw', True))
                self.assertNotIn(': wake ', self.text(name + '.hid'))

    def test_every_report_is_recorded(self):
        for name, (text, _) in TABLETS.items():
            with self.subTest(name):
                self.assertEqual(self.text(name + '.status'), '0', self.text(name + '.err'))
                self.assertEqual(self.text(name + '.hid').count('\nE:'), text.count('\nE:'))

    def read(self, name):
        """{report: state} as `penpose decode` has it of the recording; an axis that the pad does not have is 0."""
        rows = our_rows(OPTIONS.penpose, os.path.join(OPTIONS.work, name + '.hid'), 'pad')
        return {report: (together([state]), turned) for report, (state, turned) in rows.items()}

    def test_keys_rings_strips_and_dials_are_the_drivers(self):
        rows = 0
        for name in TABLETS:
            with self.subTest(name):
                kernel, whole = kernel_rows(self.text(name + '.rows'), in_one=True)
                self.assertTrue(whole, 'the kernel was not given every report')
                found = differences('pad', kernel['pad'], self.read(name))
                rows += len(kernel['pad'])
                print(f'{name:8s} {len(kernel["pad"]):4d} rows, {len(found)} differ', flush=True)
                self.assertGreater(len(kernel['pad']), 80)
                self.assertFalse(found, f'(report, driver, penpose), the first: {found[:3]}')
        print(f'{len(TABLETS)} tablets, {rows} rows', flush=True)

    def sent(self, name, second):
        """(number, report) of those that were sent with this second byte."""
        return [(i, bytes.fromhex(r)) for i, (_, r) in enumerate(reports_of(TABLETS[name][0])) if bytes.fromhex(r)[1] == second]

    def test_keys_are_those_that_were_pressed(self):
        for name, second, at in (('ring', 0xe0, 4), ('strip', 0xe0, 4), ('dial', 0xe0, 4), ('first', 0xe0, 4), ('ugee', 0xf0, 2)):
            with self.subTest(name):
                read, held = self.read(name), {}
                for i in range(COUNT):
                    held[i] = read[i][0][0] if i in read else held.get(i - 1, '-')
                for i, report in self.sent(name, second):
                    pressed = int.from_bytes(report[at:at + 2], 'little')
                    # Ten keys have numbers, those behind them names of a game pad's.
                    names = [KEYS[0x100 + k] for k in range(10) if pressed >> k & 1]
                    self.assertEqual([k for k in held[i].split('+') if k[4:].isdigit()], names, f'report {i}')

    def test_places_and_turns_are_those_of_the_finger(self):
        for name, places in (('ring', 12), ('strip', 8)):
            with self.subTest(name):
                read, found = self.read(name), {}
                for i, report in self.sent(name, 0xf0):
                    if i in read and 0 < report[5] <= places:
                        found.setdefault(report[5], set()).add(read[i][0][1])
                self.assertEqual(sorted(found), list(range(1, places + 1)))
                self.assertEqual(len(set().union(*found.values())), places, 'each place is another one')
        for name, second, at in (('dial', 0xf1, 5), ('ugee', 0xf0, 7)):
            with self.subTest(name):
                read, turns = self.read(name), {0: '0', 1: '1', 2: '-1'}
                for i, report in self.sent(name, second):
                    self.assertEqual(read[i][1][0] if i in read else '0', turns[report[at]], f'report {i}')

    def test_no_wait_inside_was_in_vain(self):
        self.assertNotIn('GAVE UP', CONSOLE)


parser = machine.parser_of('penpose', 'tools', 'work')
parser.add_argument('--keep')
OPTIONS = parser.parse_args()
machine.skip_if_missing()
FILES = {f'/traces/{name}.hid': text for name, (text, _) in TABLETS.items()}
FILES['/traces/list'] = ''.join(f'{name} {options}\n' for name, (_, options) in TABLETS.items())
ARCHIVE = machine.archive_of(OPTIONS, 'uclogic', ('driver_probe', 'pump_probe'), FILES)
RESULTS, CONSOLE = machine.ran(OPTIONS, ARCHIVE, limit_s=600)
machine.keep(RESULTS, OPTIONS.work, OPTIONS.keep)
Pads.results = RESULTS
unittest.main(argv=sys.argv[:1], verbosity=2)
