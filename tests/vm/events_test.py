#!/usr/bin/env python3
"""Pens through the kernel's event devices, in a virtual machine: the same pen through hidraw and its event device at 1000 reports a
second, one that has an event device alone with its pad and fingers, unplugging, exclusive reading, permission, and a recording that draws the same
elsewhere.

usage: events_test.py --penpose PROGRAM --tools FOLDER --work FOLDER [--count REPORTS] [--keep FOLDER]
Exit status 77 where there is no virtual machine to be had."""
import csv
import io
import json
import os
import struct
import subprocess
import sys
import unittest

import evemu
import machine
import traces

MODULES = 'virtio_pci virtio_console hid hid-generic uhid evdev uinput'.split()
SMALL = 400


def run_machine():
    short = evemu.pen(evemu.pen_states(300), 'Short Pen')
    shared = evemu.pen(evemu.leaving_states(600), 'Shared Pen')
    files = {'/traces/ink.hid': traces.header(traces.INK, 'Ink pen', '3 1b96 0021') + traces.lines(traces.ink_reports(OPTIONS.count)),
             '/traces/small.hid': traces.header(traces.INK, 'Small pen', '3 1b96 0022') + traces.lines(traces.ink_reports(SMALL)),
             '/traces/pen.evemu': PEN, '/traces/pad.evemu': evemu.pad(), '/traces/keyboard.evemu': evemu.keyboard(), '/traces/fingers.evemu': evemu.fingers(),
             '/traces/short.evemu': short, '/traces/shared.evemu': shared, '/count': str(OPTIONS.count), '/etc/hosts': ''}
    archive = machine.archive_of(OPTIONS, 'events', ('virtual_tablet', 'virtual_input', 'pump_probe'), files, MODULES)
    # One processor: the kernel's queue for event devices is short, and two that the host runs by turns lose what no machine would.
    vm = machine.Machine(OPTIONS.work, archive, limit_s=600 + OPTIONS.count // 50, memory=1024)
    try:
        results = vm.results()
    finally:
        vm.end()
        print('\n'.join(l for l in vm.text().splitlines() if 'STAGE' in l or 'GAVE UP' in l or 'no module' in l), flush=True)
    machine.keep(results, OPTIONS.keep)
    return results


def decoded(name, content, *options):
    """What the program says of a recording, row for row without times, numbers of reports and devices."""
    path = os.path.join(OPTIONS.work, name)
    with open(path, 'wb') as f:
        f.write(content.encode() if isinstance(content, str) else content)
    out = subprocess.run([OPTIONS.penpose, 'decode', path, '--csv', *options], capture_output=True, text=True, check=True).stdout
    rows = csv.DictReader(io.StringIO('\n'.join(l for l in out.splitlines() if not l.startswith('#'))))
    return [tuple(v for k, v in row.items() if k not in ('report', 'time_us', 'device')) for row in rows]


def times(content):
    found = [l.split()[1].split('.') for l in content.decode().splitlines() if l.startswith('E:')]
    return [int(s) * 1000000 + int(u) for s, u in found]


def rate(content):
    took = times(content)
    return f'{len(took) * 1e6 / max(took[-1] - took[0], 1):.0f} reports a second on the average'


class Events(machine.LeftBehind):
    def assert_only_let_go(self, samples):
        """When a device is unplugged, the kernel lets go what is held: at most one state more, of a pen that is away."""
        self.assertLessEqual(len(samples), 1)
        self.assertEqual([s[6] for s in samples], ['0'] * len(samples))

    def test_a_tablet_with_both_nodes_is_listed_once_through_hidraw(self):
        self.assertTrue(self.text('none.txt').startswith('no tablet is plugged in\npictures are drawn by '))
        tablet, = self.listed('both')
        self.assertEqual((tablet['transport'], tablet['event']), ('hidraw', None))
        self.assertIn('through hidraw: the kernel', self.text('both.txt'))

    def test_both_ways_give_the_same_samples(self):
        through_hidraw = decoded('both_hidraw.hid', RESULTS['both_hidraw.hid'])
        through_events = decoded('both_event.hid', RESULTS['both_event.hid'])
        print(f'{len(through_events)} samples through the event device, {len(through_hidraw)} through hidraw; '
              f'equal: {sum(a == b for a, b in zip(through_events, through_hidraw))} of {OPTIONS.count}; '
              f'{rate(RESULTS["both_event.hid"])}', flush=True)
        self.assertIn(' 0 lost', self.text('both_event.out'))
        self.assertEqual(len(through_hidraw), OPTIONS.count)
        self.assertTrue(through_events[:OPTIONS.count] == through_hidraw)
        self.assert_only_let_go(through_events[OPTIONS.count:])

    def test_times_are_the_kernels(self):
        took = times(RESULTS['both_event.hid'])
        self.assertEqual(took, sorted(took))
        self.assertGreaterEqual(took[-1], OPTIONS.count * 1000 * 95 // 100)

    def test_a_pen_without_hid_is_found_with_its_pad_and_its_fingers(self):
        tablets = {t['carries']: t for t in self.listed('alone')}
        self.assertEqual(sorted(tablets), ['pad', 'pen', 'touch'])
        for tablet in tablets.values():
            self.assertEqual((tablet['transport'], tablet['hidraw'], tablet['can_open']), ('event device', None, True))
            self.assertEqual((tablet['vendor'], tablet['product'], tablet['bus']), (0x2d1f, 0x95, 0x18))
            self.assertEqual(tablet['device'], tablets['pen']['device'])
        self.assertIn('through its event device: there is no HID interface behind it', self.text('alone.txt'))

    def test_all_of_its_samples_arrive_up_to_its_unplugging(self):
        samples = decoded('alone.hid', RESULTS['alone.hid'])
        sent = decoded('pen.evemu', PEN)
        print(f'{len(samples)} of {len(sent)} samples of the pen alone; equal: {sum(a == b for a, b in zip(samples, sent))}; '
              f'{rate(RESULTS["alone.hid"])}', flush=True)
        self.assertEqual(self.text('alone.status'), '0', self.text('alone.err'))
        self.assertIn('Board Pen was unplugged', self.text('alone.err'))
        self.assertTrue(samples[:OPTIONS.count] == sent)
        self.assert_only_let_go(samples[OPTIONS.count:])
        self.assertIn(f' {OPTIONS.count // 200} strokes', self.text('alone.out'))

    def test_a_recording_of_evemu_is_what_was_played(self):
        rows = decoded('pen.evemu', PEN)
        self.assertEqual(len(rows), OPTIONS.count)
        for row, s in zip(rows, evemu.pen_states(OPTIONS.count)):
            x, y, pressure, tilt_x, tilt_y, distance, in_range, tool, tip, button1 = row[:10]
            self.assertEqual((int(x), int(y), int(pressure), int(tilt_x), int(tilt_y), int(distance)), s[:6])
            self.assertEqual((in_range, tool, tip, button1), ('1', s.tool, str(int(s.tip)), str(int(s.button1))))

    def test_keys_rings_wheels_and_fingers_are_those_that_were_played(self):
        for kind, file, text in (('--pad', 'pad.evemu', evemu.pad()), ('--touch', 'fingers.evemu', evemu.fingers())):
            with self.subTest(kind):
                rows, sent = decoded('alone.hid', RESULTS['alone.hid'], kind), decoded(file, text, kind)
                self.assertGreater(len(sent), 40)
                self.assertEqual(rows[:len(sent)], sent)
                # The key that was held when it was unplugged is let go by the kernel.
                self.assertEqual([row[0] for row in rows[len(sent):]], ['-'] * (len(rows) - len(sent)))

    def test_a_look_at_ten_event_devices_takes_little_time(self):
        none, ten = (json.loads(self.text('listing.' + n)) for n in ('none', 'ten'))
        print(f'without event devices: {none}; with ten: {ten}', flush=True)
        self.assertEqual((none['event_tablets'], ten['event_tablets']), (0, 3))
        self.assertLess(ten['events_us'], 1_000_000)

    def test_coming_and_going_is_seen(self):
        log = self.text('watch.log').splitlines()
        for name in ('Board Pen', 'Board Pad', 'Board Finger'):
            for what in ('arrived', 'left'):
                self.assertEqual(len([l for l in log if l.startswith(what) and l.endswith(name)]), 1, (what, name, log))

    def test_what_the_kernel_dropped_is_told_and_the_state_after_it_is_right(self):
        self.assertIn("the system's queue was full", self.text('stalled.hid'))
        last = [s for s in decoded('stalled.hid', RESULTS['stalled.hid']) if s[6] == '1'][-1]
        self.assertEqual(last, decoded('short.evemu', evemu.pen(evemu.pen_states(300), 'Short Pen'))[-1])

    def touches_of_the_desktop(self):
        """BTN_TOUCH of a reader that has been there all the time and asks for nothing."""
        events = [struct.unpack('qqHHi', RESULTS['desktop.raw'][i:i + 24]) for i in range(0, len(RESULTS['desktop.raw']), 24)]
        return [value for _, _, kind, code, value in events if (kind, code) == (evemu.KEY, evemu.TOUCH)]

    def test_what_is_recorded_does_not_reach_the_desktop_and_no_stroke_is_halved(self):
        # The first of twelve strokes had begun when the first recorder came, and eight were recorded.
        self.assertEqual(self.text('desktop.while'), self.text('desktop.before'))
        self.assertEqual(self.touches_of_the_desktop(), [1, 0] * (1 + 4))
        played = decoded('shared.evemu', evemu.pen(evemu.leaving_states(600), 'Shared Pen'))
        self.assertEqual(decoded('first.hid', RESULTS['first.hid']), played[25:200])
        self.assertEqual(decoded('second.hid', RESULTS['second.hid']), played[200:400])

    def test_whom_another_program_keeps_from_the_pen_is_told_until_that_ends(self):
        self.assertEqual(self.text('first.err').count('another program'), 0)
        self.assertIn('penpose: Shared Pen: another program has it for itself, so nothing comes; close that program', self.text('second.err'))
        self.assertIn('the other program let go', self.text('second.hid'))

    def test_who_may_open_the_event_device_alone_reads_that(self):
        tablet, = self.listed('member')
        self.assertEqual((tablet['transport'], tablet['can_open'], tablet['missing']), ('event device', True, None))
        self.assertEqual(tablet['transport_reason'], 'its HID interface cannot be opened')
        wanted = decoded('small.hid', traces.header(traces.INK, 'Small pen', '3 1b96 0022') + traces.lines(traces.ink_reports(SMALL)))
        self.assertEqual(decoded('member.hid', RESULTS['member.hid'])[:SMALL], wanted)

    def test_who_may_open_neither_is_told_what_helps(self):
        said = self.text('guest.txt')
        self.assertEqual(said.count('Small pen'), 1)
        self.assertIn('cannot be opened', said)
        self.assertIn('devices --install-udev-rule', said)

    def test_what_was_recorded_draws_the_same_elsewhere(self):
        there = json.loads(self.text('here.json'))
        path = os.path.join(OPTIONS.work, 'here.session')
        with open(path, 'wb') as f:
            f.write(RESULTS['here.session'])
        out = subprocess.run([OPTIONS.penpose, 'replay', path, '--json'], capture_output=True, text=True, check=True).stdout
        here = json.loads(out)
        self.assertGreater(there['strokes'], 3)
        self.assertEqual((here['strokes'], here['state']), (there['strokes'], there['state']))


parser = machine.parser_of('penpose', 'tools', 'work')
parser.add_argument('--count', type=int, default=60000)
parser.add_argument('--keep')
OPTIONS = parser.parse_args()
machine.skip_if_missing()
PEN = evemu.pen(evemu.pen_states(OPTIONS.count))
RESULTS = Events.results = run_machine()
unittest.main(argv=sys.argv[:1], verbosity=2)
