#!/usr/bin/env python3
"""Real tablets on a real kernel, without hardware: boots a virtual machine, plugs tablets into it, draws with them, pulls them
out, and compares what `penpose` recorded inside with what was sent.

usage: tablets_test.py --penpose PROGRAM --tools FOLDER --work FOLDER [--shared FOLDER] [--keep FOLDER]
Exit status 77 where there is no virtual machine to be had."""
import csv
import io
import os
import subprocess
import sys
import time
import unittest

import machine
import traces
from emulated_pen import Pen

# Recordings of real tablets, where they are at hand; the first reports of their pen interface are enough.
REAL = ['Wacom_Graphire3_056a_0013', 'Wacom_BambooFun_4x5_056a_0017', 'Wacom_Cintiq_22HD_056a_00FA', 'Wacom_Intuos_Pro_S_056a_0314']
MOST_REPORTS = 1200


def pen_part(text):
    """The recording with all its interfaces, and of its reports the first of interface 0."""
    kept, number, count = [], 0, 0
    for line in text.splitlines():
        if line.startswith('D:'):
            number = int(line[2:])
        if line.startswith('E:'):
            if number != 0 or count == MOST_REPORTS:
                continue
            count += 1
        kept.append(line)
    return '\n'.join(kept) + '\n'


def all_traces(shared):
    found = traces.made()
    for name in REAL:
        path = os.path.join(shared or '', 'hid', name + '.hid')
        if os.path.exists(path):
            with open(path, encoding='utf-8', errors='replace') as f:
                found['wacom_real_' + name[-4:].lower()] = pen_part(f.read())
    return found


def strokes_of(samples):
    """Runs of samples with the tip down."""
    strokes, down = [], False
    for x, y, pressure, tip in samples:
        if tip and not down:
            strokes.append([])
        if tip:
            strokes[-1].append((x, y, pressure))
        down = tip
    return strokes


def run_machine(options):
    """Boots, plays and gives (results by name, traces by name, the pen)."""
    sent = all_traces(options.shared)
    files = {f'/traces/{name}.hid': text for name, text in sent.items()}
    archive = machine.archive_of(options, 'tablets', ('virtual_tablet', 'pump_probe'), files)
    vm = machine.Machine(options.work, archive, limit_s=600, processors=2)
    try:
        begin = time.monotonic()
        vm.wait_for_mark('plug')
        print(f'booted after {time.monotonic() - begin:.1f} s', flush=True)
        vm.command('device_add', driver='usb-wacom-tablet', bus='usb.0', id='pen')
        # The device forgets its mouse when its driver is bound anew, so it is plugged in anew for drawing.
        vm.wait_for_mark('pull')
        vm.command('device_del', id='pen')
        vm.wait_for_mark('again')
        vm.command('device_add', driver='usb-wacom-tablet', bus='usb.0', id='pen', pcap=os.path.join(options.work, 'penpartner.pcap'))
        vm.wait_for_mark('draw')
        pen = Pen(vm)
        pen.draw()
        vm.command('device_del', id='pen')
        vm.wait_for_mark('sleep', 300)
        vm.wait(lambda: vm.command('query-status')['status'] == 'suspended', 'its sleep', 60)
        time.sleep(1.1)
        vm.command('system_wakeup')
        vm.wait_for_mark('awake', 60)
        results = vm.results()
        results['penpartner.hid'] = pen.trace()
        print(f'ended after {time.monotonic() - begin:.1f} s', flush=True)
    finally:
        vm.end()
    machine.keep(results, options.keep)
    return results, sent, pen


class Tablets(machine.LeftBehind):
    def part(self, recording, name):
        """What one trace's tablet sent, out of a recording of many."""
        text = self.text(recording + '.hid')
        number = traces.declared(text).index(traces.declared(SENT[name])[0])
        return [r for n, r in traces.reports_of(text) if n == number]

    def assert_recorded(self, name, recording='many', count=None):
        """The recording holds every report that was sent, byte for byte and in order."""
        recorded = self.part(recording, name)
        wanted = [r for _, r in traces.reports_of(SENT[name])][:count]
        self.assertEqual(self.text(recording + '.status'), '0', self.text(recording + '.err'))
        self.assertEqual(len(recorded), len(wanted), self.text(recording + '.out'))
        self.assertEqual(recorded, wanted)
        self.assertIn(' 0 lost', self.text(recording + '.out'))

    def one_of_many(self, name):
        ids = tuple(int(word, 16) for word in traces.declared(SENT[name])[0].split())
        tablet, = [t for t in self.listed('many') if (t['vendor'], t['product']) == ids and t['carries'] == 'pen']
        return tablet

    def hand(self, name, kind):
        """What the program makes of the keys or the fingers of a recording, row for row without times and reports."""
        path = os.path.join(OPTIONS.work, name)
        with open(path, 'wb') as f:
            f.write(SENT[name[:-5]].encode() if name.endswith('.sent') else RESULTS[name])
        out = subprocess.run([OPTIONS.penpose, 'decode', path, '--' + kind, '--csv'], capture_output=True, text=True, check=True).stdout
        return [row.split(',')[2:] for row in out.splitlines()[1:]]

    def samples(self, name, text=None):
        """(x, y, pressure, tip) of every pen sample of a recording, as the program decodes it."""
        path = os.path.join(OPTIONS.work, name + '.hid')
        with open(path, 'wb') as f:
            f.write(text.encode() if text else RESULTS[name + '.hid'])
        out = subprocess.run([OPTIONS.penpose, 'decode', path, '--csv'], capture_output=True, text=True, check=True).stdout
        rows = csv.DictReader(io.StringIO('\n'.join(l for l in out.splitlines() if not l.startswith('#'))))
        return [(int(r['x']), int(r['y']), int(r['pressure'] or 0), r['tip'] == '1') for r in rows]

    def test_nothing_is_plugged_in_at_first(self):
        self.assertTrue(self.text('none.txt').startswith('no tablet is plugged in\npictures are drawn by '))

    def test_the_emulated_pen_is_found_and_read_through_libusb(self):
        tablet, = self.listed('penpartner')
        self.assertEqual((tablet['vendor'], tablet['product']), (0x056a, 0))
        self.assertEqual(tablet['transport'], 'libusb')
        self.assertEqual(tablet['carries'], 'pen')
        self.assertTrue(tablet['can_open'])

    def test_its_strokes_are_those_that_were_drawn(self):
        samples = self.samples('penpartner')
        self.assertEqual(samples, PEN.sent)
        strokes = strokes_of(samples)
        self.assertEqual(strokes, strokes_of(PEN.sent))
        self.assertEqual(len(strokes), 3)
        self.assertIn(' 3 strokes', self.text('penpartner.out'))

    def test_the_capture_that_the_emulator_makes_itself_holds_the_same(self):
        with open(os.path.join(OPTIONS.work, 'penpartner.pcap'), 'rb') as f:
            RESULTS['penpartner.pcap.hid'] = f.read()
        self.assertEqual(self.samples('penpartner.pcap'), self.samples('penpartner'))

    def test_without_its_driver_it_is_made_a_pen_before_its_first_report(self):
        self.assertEqual(self.text('hid_driver_before'), 'wacom')
        lines = self.text('penpartner.hid').splitlines()
        woken = lines.index('# 0: wake feature 02 02: sent')
        self.assertLess(woken, next(i for i, l in enumerate(lines) if l.startswith('E:')))

    def test_pulled_out_while_it_draws_the_recording_ends_well(self):
        self.assertEqual(self.text('penpartner.status'), '0')
        self.assertIn('was unplugged', self.text('penpartner.err'))
        self.assertTrue(RESULTS['penpartner.hid'].endswith(b'\n'))

    def test_the_driver_is_taken_and_given_back(self):
        self.assertNotIn('cannot be opened', self.text('penpartner.err'))
        self.assertEqual(self.text('driver_before'), 'usbhid')
        self.assertEqual(self.text('driver_while'), 'usbfs')
        self.assertEqual(self.text('driver_after'), 'usbhid')
        self.assertEqual(self.text('orderly.status'), '0')

    def test_the_driver_is_given_back_after_a_kill(self):
        self.assertEqual(self.text('driver_while_killed'), 'usbfs')
        self.assertEqual(self.text('driver_after_kill'), 'usbhid')
        tablet, = self.listed('after_kill')
        self.assertTrue(tablet['can_open'])

    def test_an_ink_pen_arrives_byte_for_byte_up_to_its_unplugging(self):
        tablet = self.one_of_many('ink')
        self.assertEqual((tablet['method'], tablet['transport']), ('descriptor', 'hidraw'))
        self.assert_recorded('ink')
        self.assertEqual(len(strokes_of(self.samples('ink', traces.only(self.text('many.hid'), '1b96 0021')))), 12)
        self.assertIn('Ink pen was unplugged', self.text('many.err'))

    def test_wacom_tablets_arrive_byte_for_byte_beside_their_driver(self):
        for name in sorted(name for name in SENT if name.startswith('wacom_')):
            with self.subTest(name):
                tablet = self.one_of_many(name)
                self.assertEqual(tablet['driver'], 'wacom')
                self.assertEqual(tablet['transport'], 'hidraw')
                self.assertEqual(tablet['interface'], 0)
                self.assertTrue(tablet['method'].startswith('wacom '))
                self.assert_recorded(name)

    def test_many_tablets_at_once_one_pulled_out_while_it_draws_and_one_that_joins(self):
        self.assertEqual(len(self.listed('many')), sum(len(traces.declared(t)) for n, t in SENT.items() if n.startswith('wacom_')) + 5)
        self.assert_recorded('pulled', count=60)
        self.assertIn('Pulled pen was unplugged', self.text('many.err'))
        self.assert_recorded('late')
        self.assertNotIn('cannot be opened', self.text('many.err'))

    def test_what_the_kernel_dropped_while_the_program_stood_still_is_told(self):
        sent = [r for _, r in traces.reports_of(SENT['stalled'])]
        self.assertEqual(self.part('many', 'stalled'), sent[:63], 'the kernel keeps another number than is written in queue_gauge.h')
        self.assertIn("the system's queue was full", traces.only(self.text('many.hid'), '1b96 0026'))
        self.assertIn("Stalled pen: the system's queue was full 1 times", self.text('many.err'))
        self.assertEqual(self.text('many.hid').count("the system's queue was full"), 1)

    def test_garbage_is_recorded_and_harms_nothing(self):
        sent = [r for _, r in traces.reports_of(SENT['garbage'])]
        recorded = self.part('many', 'garbage')
        self.assertGreater(len(recorded), 50)
        left = iter(sent)
        # The kernel keeps reports of unknown ids and of too few bytes to itself.
        self.assertTrue(all(any(r == s for s in left) for r in recorded), 'recorded what was never sent')
        self.samples('garbage', traces.only(self.text('many.hid'), '1b96 0022'))
        self.assertEqual(self.text('many.devices_status'), '0')
        self.assertIn('plugged in', self.text('garbage_descriptor.sent'))

    def test_a_sleeping_tablet_is_told_apart_and_woken(self):
        tablet = self.one_of_many('huion')
        self.assertEqual((tablet['tablet'], tablet['transport']), ('Huion H640P', 'libusb'))
        self.assertEqual(tablet['strings']['201'], 'HUION_T173_200101')
        self.assertNotIn('200', tablet['strings'], 'the listing already woke it up')
        # The kernel's driver refused it, so its descriptor is only known once it is open.
        text = self.text('many.hid')
        self.assertIn(f'R: {len(traces.HUION)} {traces.HUION.hex(" ")}', text)
        self.assertIn(f'# {traces.declared(text).index("256c 006d")}: wake string 200: "waking"', text)
        self.assert_recorded('huion')
        self.assertEqual(self.text('huion_driver_while'), 'usbfs')
        self.assertEqual(self.text('huion_driver_after'), 'usbhid')

    def test_a_tablet_that_the_kernel_has_woken_is_read_as_the_kernel_shows_it(self):
        tablet = self.one_of_many('uclogic')
        self.assertEqual((tablet['driver'], tablet['transport'], tablet['method']), ('uclogic', 'hidraw', tablet['method']))
        self.assertTrue(tablet['method'].startswith('descriptor'))
        text = traces.only(self.text('many.hid'), '256c 006e')
        self.assertNotIn(': wake ', text)
        # The driver has moved bytes and turned a bit round in each report; the pen is where it was all the same.
        sent = [(i * 61 % 32000, i * 47 % 20000, 3000 + i % 1000 if i % 50 < 40 else 0, i % 50 < 40) for i in range(300)]
        self.assertEqual(self.samples('uclogic', text), sent)

    def test_after_a_sleep_of_the_machine_a_tablet_is_woken_again(self):
        lines = self.text('parblo.hid').splitlines()
        woken = [i for i, l in enumerate(lines) if l == '# 0: wake feature 02 02: sent']
        slept = [i for i, l in enumerate(lines) if l.startswith('# 0: the system slept for ')]
        first = next(i for i, l in enumerate(lines) if l.startswith('E:'))
        self.assertEqual((len(woken), len(slept)), (2, 1))
        self.assertTrue(woken[0] < slept[0] < woken[1] < first)
        self.assertEqual(self.text('parblo.sent').count('took report 02 02'), 2)
        self.assert_recorded('parblo', 'parblo')

    def test_coming_and_going_is_seen_while_running(self):
        log = self.text('watch.log').splitlines()
        names = [l[3:] for n in SENT if n != 'garbage_descriptor' for l in SENT[n].splitlines() if l.startswith('N: ')]
        names += ['Wacom Intuos Pro S'] * 2  # plugged in twice, with two interfaces
        # The kernel makes their nodes anew while they are plugged in.
        names = [name for name in names if name not in ('Wacom Wireless Receiver', 'Wacom Intuos Pro M')]
        for name in set(names):
            arrived = [i for i, l in enumerate(log) if l.startswith('arrived ') and l.endswith(name)]
            left = [i for i, l in enumerate(log) if l.startswith('left ') and l.endswith(name)]
            self.assertEqual((len(arrived), len(left)), (names.count(name), names.count(name)), name)
            self.assertLess(arrived[0], left[0], name)
        # Taken from its driver and given back, twice, and killed: it was plugged in and pulled out twice all the same.
        for what in ('arrived', 'left'):
            self.assertEqual(len([l for l in log if l.startswith(what) and 'PenPartner' in l]), 2, what)

    def test_keys_and_fingers_of_a_tablet_with_two_interfaces(self):
        pen, touch = sorted(self.listed('hand'), key=lambda t: t['interface'])
        self.assertEqual((pen['carries'], pen['keys'], pen['transport'], pen['driver']), ('pen', True, 'hidraw', 'wacom'))
        self.assertEqual((touch['carries'], touch['touch'], touch['transport']), ('touch', True, 'hidraw'))
        self.assertEqual(pen['device'], touch['device'])
        sent, recorded = traces.reports_of(SENT['hand']), traces.reports_of(self.text('hand.hid'))
        for number in (0, 1):
            self.assertEqual([r for n, r in recorded if n == number], [r for n, r in sent if n == number])
        for kind, rows in (('pad', 40), ('touch', 40)):
            wanted = self.hand('hand.sent', kind)
            self.assertGreater(len(wanted), rows)
            self.assertEqual(self.hand('hand.hid', kind), wanted)
        self.assertIn(' 8 keys', self.text('hand.out'))

    def test_a_key_that_is_held_when_its_tablet_is_pulled_out_is_let_go_and_said(self):
        self.assertIn('Wacom Intuos Pro S was unplugged with BTN_2 held: let go', self.text('hand.err'))
        self.assertIn('held at its end and let go: BTN_2', self.text('hand.hid'))
        self.assertEqual(self.text('hand.status'), '0')

    def rows(self, name, kind):
        """What the program makes of a recording, row for row, without the numbers of reports, times and devices."""
        path = os.path.join(OPTIONS.work, name)
        with open(path, 'wb') as f:
            f.write(SENT[name[:-5]].encode() if name.endswith('.sent') else RESULTS[name])
        command = [OPTIONS.penpose, 'decode', path, '--csv'] + ([f'--{kind}'] if kind != 'pen' else [])
        out = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        reader = csv.DictReader(io.StringIO('\n'.join(l for l in out.splitlines() if not l.startswith('#'))))
        return [{k: v for k, v in r.items() if k not in ('report', 'time_us', 'device')} for r in reader]

    def test_a_tablet_behind_a_wireless_receiver_is_read_as_by_cable(self):
        monitor, pen, touch = sorted(self.listed('receiver'), key=lambda t: t['interface'])
        self.assertEqual((monitor['carries'], pen['carries'], touch['carries']), ('receiver', 'pen', 'touch'))
        self.assertEqual({t['transport'] for t in (monitor, pen, touch)}, {'hidraw'})
        for kind, least in (('pen', 50), ('pad', 40), ('touch', 40)):
            behind, by_cable = self.rows('receiver.hid', kind), self.rows('hand.sent', kind)
            self.assertGreater(len(by_cable), least)
            self.assertEqual(behind, by_cable, kind)
        self.assertIn(' 8 keys', self.text('receiver.out'))
        self.assertIn('held at its end and let go: BTN_2', self.text('receiver.hid'))
        self.assertEqual(self.text('receiver.status'), '0')

    def test_the_kernels_driver_switches_the_light_and_we_see_which_is_on(self):
        log = self.text('lights_kernel.log').splitlines()
        self.assertEqual(log[:-1], ['seen 0', 'kernel', 'light 0', 'light 1', 'light 2', 'light 3'])
        # Two bits say which light is on, two more how bright. In a slow machine the driver may miss presses; we send nothing.
        lights = [int(taken[3:], 16) & 3 for taken in self.lights_taken('lights_kernel')]
        self.assertEqual(lights, sorted(lights))
        self.assertGreater(lights[-1], 0)
        self.assertEqual(log[-1], f'seen {lights[-1]}')
        self.assertEqual(self.text('lights_kernel.again').splitlines()[0], f'seen {lights[-1]}', 'and a program that starts then sees it')

    def test_without_its_driver_we_switch_the_light(self):
        self.assertEqual(self.text('lights_bare.log').splitlines(), ['seen none', 'ready', 'light 0', 'light 1', 'light 2', 'light 3', 'seen none'])
        self.assertEqual(self.lights_taken('lights_bare')[:4], ['20 00', '20 01', '20 02', '20 03'])

    def lights_taken(self, name):
        """The begin of the reports of lights that the device was sent, without repetitions."""
        taken = [l[len('took report '):][:5] for l in self.text(name + '.sent').splitlines() if l.startswith('took report 20 ')]
        return [t for i, t in enumerate(taken) if i == 0 or taken[i - 1] != t]

    def test_fingers_are_read_through_libusb_from_their_own_interface(self):
        self.assertIn('usb:', self.text('hand_usb.err'))
        sent = [r for n, r in traces.reports_of(SENT['hand']) if n == 1]
        self.assertEqual([r for _, r in traces.reports_of(self.text('hand_usb.hid'))], sent)

    def test_no_wait_inside_was_in_vain(self):
        self.assertNotIn('GAVE UP', CONSOLE)


parser = machine.parser_of('penpose', 'tools', 'work')
parser.add_argument('--shared')
parser.add_argument('--keep')
OPTIONS = parser.parse_args()
machine.skip_if_missing()
RESULTS, SENT, PEN = run_machine(OPTIONS)
with open(os.path.join(OPTIONS.work, 'console'), 'rb') as f:
    CONSOLE = f.read().decode(errors='replace')
print(CONSOLE[-1500:])
Tablets.results = RESULTS
unittest.main(argv=sys.argv[:1], verbosity=2)
