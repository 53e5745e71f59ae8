"""A board that boots into the window: 128 MB of memory, one processor, 800x480, no OpenGL, by the files that ship for it.

usage: boot_test.py --penpose PROGRAM --build FOLDER --tools FOLDER --work FOLDER [--init busybox|systemd] [--size WIDTHxHEIGHT] [--swap]

busybox: BusyBox's init with the line of boards/inittab.line. systemd: Debian's systemd, udev and logind with boards/penpose.service.
swap: into compressed memory (zram), without which Debian's kernel, which takes 50 MB before anything runs, leaves too little for systemd or
for 1280x800.
A pen draws through the kernel's uhid; the session that the board keeps replays here to the state that it had there. Ends with
status 77 (skipped) where QEMU, the kernel or a package of the board's is missing.
"""
import json
import os
import subprocess
import sys
import unittest

import board
import machine
import screen_picture

MEMORY_MB = 128
# Along the mouth of the built-in head and where it should go, in shares of a screen of this size.
SIZE = (800, 480)
LINES = [[(0.5335 + 0.006 * i, 0.452 + 0.0003 * i * (8 - i)) for i in range(9)], [(0.5285 + 0.00725 * i, 0.43 + 0.002 * i * (8 - i)) for i in range(9)]]
MODULES = 'virtio_pci virtio_blk ext4 virtio_console bochs hid hid-generic uhid usbhid evdev xhci-pci'.split()
SWAP = 'lzo lzo-rle zram'.split()


def trace():
    """What a pen of a panel on I2C sends that draws these lines; its descriptor is the virtual pen's, as sessions have it."""
    with open(os.path.join(machine.HERE, '../../ui/demo/demo.session'), encoding='utf-8') as f:
        lines = [next(line for line in f if line.startswith('R:')), 'N: Board Pen\n', 'P: virtual/input0\n', 'I: 18 2d1f 0095\n']
    seconds = 0.0

    def report(x, y, touches):
        nonlocal seconds
        seconds += 0.003
        body = bytes([1, 3 if touches else 1]) + b''.join(value.to_bytes(2, 'little') for value in
                                                          (round(x * 65535), round(y * 65535), 2500 if touches else 0))
        lines.append(f'E: {seconds:.6f} {len(body)} {body.hex(" ")}\n')

    for points in LINES:
        for _ in range(50):
            report(*points[0], False)
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            for i in range(12):
                report(x0 + (x1 - x0) * i / 12, y0 + (y1 - y0) * i / 12, True)
        for _ in range(50):
            report(*points[-1], False)
    return ''.join(lines)


class Boot(unittest.TestCase):
    def test_the_head_is_seen(self):
        picture = screen_picture.read(SHOT)
        self.assertEqual((len(picture[0]), len(picture)), OPTIONS.size)
        self.assertGreater(screen_picture.skin_in(picture), screen_picture.LEAST_SKIN)

    def test_what_was_drawn_replays_elsewhere_to_the_same_state(self):
        session = os.path.join(OPTIONS.work, 'drawn.session')
        with open(session, 'wb') as f:
            f.write(RESULTS['drawn.session'])
        states = [line.split()[3] for line in RESULTS['drawn.session'].decode().splitlines() if line.startswith('# penpose state')]
        told = json.loads(subprocess.run([OPTIONS.penpose, 'replay', session, '--json'], check=True, capture_output=True, text=True).stdout)
        self.assertEqual((told['reports'], told['strokes'], told['differing']), (trace().count('E:'), len(LINES), 0))
        self.assertEqual(told['state'], states[-1])
        self.assertTrue(OPTIONS.size != SIZE or any(told['parameters'].values()))

    def test_it_needs_64_mb_at_most(self):
        memory = {line.split()[0]: line.split()[1] for line in RESULTS['memory'].decode().splitlines()}
        print(memory)
        self.assertLessEqual(int(memory['VmHWM:']) + int(memory['VmSwap:']), 64 * 1024)

    def test_the_unit_runs_it_as_its_user_at_the_seat(self):
        if OPTIONS.init != 'systemd':
            self.skipTest('without systemd')
        unit = dict(line.split('=', 1) for line in RESULTS['unit'].decode().splitlines())
        self.assertEqual((unit['Result'], unit['ExecMainStatus'], unit['NRestarts']), ('success', '0', '0'), RESULTS['journal'].decode())
        self.assertRegex(RESULTS['sessions'].decode(), r'penpose\s+seat0\s+tty1')
        self.assertIn(f'Uid:\t{board.USER}\t', RESULTS['memory'].decode())


def run_machine(options):
    os.makedirs(options.work, exist_ok=True)
    disk = board.Board(options.work)
    disk.add_busybox()
    disk.add(os.path.join(options.tools, 'virtual_tablet'), '/usr/bin/virtual_tablet')
    disk.put('/traces/drawn.hid', trace())
    for home in ('/root', '/home/penpose'):
        disk.put(home + '/.config/penpose/settings', 'steps_seen=1\npose_first=1\n')
    boards = disk.install(options.build)
    (disk.start_by_systemd if options.init == 'systemd' else disk.start_by_busybox)(boards)
    with open(os.path.join(machine.HERE, 'guest/boot.sh'), encoding='utf-8') as f:
        archive = machine.build_initramfs(options.work, [], {'/job.sh': f.read()}, MODULES + (SWAP if options.swap else []))
    width, height = options.size
    vm = machine.Machine(options.work, archive, memory=MEMORY_MB, processors=1, disk=disk.image(128),
                         devices=(f'bochs-display,xres={width},yres={height}', 'usb-tablet,bus=usb.0,id=mouse', 'usb-kbd,bus=usb.0,id=keyboard'))
    shot = os.path.join(options.work, 'screen.ppm')
    try:
        vm.wait_for_mark('window', 300)
        screen_picture.look_until(vm, shot, screen_picture.shows_head, 120)
        vm.command('device_del', id='mouse')
        vm.wait_for_mark('drawn', 300)
        vm.command('screendump', filename=shot)
        vm.command('device_del', id='keyboard')
        return vm.results(), shot
    finally:
        vm.end()
        print('\n'.join(line for line in vm.text().splitlines() if line.startswith(('MARK', 'STAGE', 'GAVE UP'))), flush=True)


parser = machine.parser_of('penpose', 'build', 'tools', 'work')
parser.add_argument('--init', choices=('busybox', 'systemd'), default='busybox')
parser.add_argument('--swap', action='store_true')
parser.add_argument('--size', type=lambda text: tuple(int(side) for side in text.split('x')), default=SIZE)
OPTIONS = parser.parse_args()
machine.skip_if_missing([board.FONT])
if OPTIONS.init == 'systemd' and board.missing_packages():
    print('SKIPPED: no board with systemd without these packages:', *board.missing_packages())
    sys.exit(77)
RESULTS, SHOT = run_machine(OPTIONS)
unittest.main(argv=[sys.argv[0], '-v'])
