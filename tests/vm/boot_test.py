"""A board that boots into the window: 128 MB of memory, one processor, no OpenGL, BusyBox's init with the line that ships.

usage: boot_test.py --penpose PROGRAM --tools FOLDER --work FOLDER

A pen draws through the kernel's uhid; the session that the machine keeps replays here to the state that it had there. Ends with
status 77 (skipped) where QEMU or the kernel is missing.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import time
import unittest

import machine
import screen_picture

FONT = '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf'
SOURCE = os.path.join(machine.HERE, '../..')
MEMORY = 128
LEAST_SKIN = 0.02
# Along the mouth of the built-in head and where it should go, in shares of the screen.
LINES = [[(0.338 + 0.006 * i, 0.452 + 0.0003 * i * (8 - i)) for i in range(9)], [(0.333 + 0.00725 * i, 0.43 + 0.002 * i * (8 - i)) for i in range(9)]]


def trace():
    """What a pen sends that draws these lines: the virtual pen's descriptor, as sessions have it."""
    with open(os.path.join(SOURCE, 'ui/demo/demo.session'), encoding='utf-8') as f:
        lines = [line for line in f if line[:2] in ('R:', 'N:', 'I:')][:3]
    seconds = 0.0

    def report(x, y, touches):
        nonlocal seconds
        seconds += 0.003
        body = bytes([1, 3 if touches else 1]) + b''.join(value.to_bytes(2, 'little') for value in
                                                          (round(x * 65535), round(y * 65535), 2500 if touches else 0))
        lines.append(f'E: {seconds:.6f} {len(body)} {body.hex(" ")}\n')

    for points in LINES:
        for _ in range(100):
            report(*points[0], False)
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            for i in range(12):
                report(x0 + (x1 - x0) * i / 12, y0 + (y1 - y0) * i / 12, True)
        for _ in range(100):
            report(*points[-1], False)
    return ''.join(lines)


class Boot(unittest.TestCase):
    def test_the_head_is_seen(self):
        self.assertGreater(screen_picture.skin_in(screen_picture.read(SHOT)), LEAST_SKIN)

    def test_what_was_drawn_replays_elsewhere_to_the_same_state(self):
        session = os.path.join(OPTIONS.work, 'drawn.session')
        with open(session, 'wb') as f:
            f.write(RESULTS['drawn.session'])
        states = [line.split()[3] for line in RESULTS['drawn.session'].decode().splitlines() if line.startswith('# penpose state')]
        self.assertGreater(len(set(states)), 1)
        replayed = subprocess.run([OPTIONS.penpose, 'replay', session, '--json'], check=True, capture_output=True, text=True).stdout
        self.assertEqual(json.loads(replayed)['state'], states[-1])

    def test_it_needs_64_mb_at_most(self):
        memory = {line.split()[0]: int(line.split()[1]) for line in RESULTS['memory'].decode().splitlines()}
        print(memory)
        self.assertLess(memory['VmHWM:'], 64 * 1024)


def disk_of_programs(folder):
    """Moves programs and libraries onto a disk, as a board has them, so that they take memory only where they are used."""
    root, board, image = (os.path.join(folder, name) for name in ('root', 'board', 'board.img'))
    shutil.rmtree(board, ignore_errors=True)
    for source, names in (('bin', ('penpose', 'virtual_tablet')), ('lib', [n for n in os.listdir(os.path.join(root, 'lib')) if '.so' in n])):
        os.makedirs(os.path.join(board, source))
        for name in names:
            shutil.move(os.path.join(root, source, name), os.path.join(board, source, name))
    if os.path.exists(image):
        os.unlink(image)
    subprocess.run([machine.find('mke2fs'), '-q', '-t', 'ext4', '-O', '^has_journal', '-d', board, image, '96M'], check=True)
    return image


def run_machine(options):
    os.makedirs(options.work, exist_ok=True)
    files = {'/traces/drawn.hid': trace()}
    for target, source in (('/job.sh', 'tests/vm/guest/boot.sh'), ('/drawing.sh', 'tests/vm/guest/drawing.sh'), ('/inittab.line', 'ui/install/boards/inittab.line')):
        with open(os.path.join(SOURCE, source), encoding='utf-8') as f:
            files[target] = f.read().replace('@CMAKE_INSTALL_FULL_BINDIR@', '/usr/bin')
    modules = 'virtio_pci virtio_blk ext4 virtio_console bochs hid hid-generic uhid usbhid evdev xhci-pci'.split()
    machine.build_initramfs(options.work, [options.penpose, os.path.join(options.tools, 'virtual_tablet')], files, modules, [FONT])
    disk = disk_of_programs(options.work)
    vm = machine.Machine(options.work, machine.pack(options.work), memory=MEMORY, processors=1, disk=disk,
                         devices=('bochs-display,xres=800,yres=480', 'usb-tablet,bus=usb.0,id=mouse', 'usb-kbd,bus=usb.0,id=keyboard'))
    shot = os.path.join(options.work, 'screen.ppm')
    try:
        vm.wait_for_mark('window', 600)
        until = time.monotonic() + 300
        while time.monotonic() < until:
            time.sleep(2)
            vm.command('screendump', filename=shot)
            if screen_picture.skin_in(screen_picture.read(shot)) > LEAST_SKIN:
                break
        vm.command('device_del', id='mouse')
        vm.wait_for_mark('drawn', 600)
        vm.command('screendump', filename=shot)
        vm.command('device_del', id='keyboard')
        return vm.results(), shot
    finally:
        vm.end()


parser = argparse.ArgumentParser()
parser.add_argument('--penpose', required=True)
parser.add_argument('--tools', required=True)
parser.add_argument('--work', required=True)
OPTIONS = parser.parse_args()
machine.skip_if_missing([FONT])
RESULTS, SHOT = run_machine(OPTIONS)
unittest.main(argv=[sys.argv[0], '-v'])
