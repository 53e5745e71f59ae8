"""The window on a machine without a desktop: SDL's KMS/DRM driver and Mesa's software renderer on QEMU's plainest screen. A pen
that has an event device alone draws in it.

usage: event_screen_test.py --penpose PROGRAM --tools FOLDER --work FOLDER

Looks at what the screen shows and at how the program ends. Ends with status 77 (skipped) where QEMU, the kernel or Mesa's
files are missing.
"""
import json
import os
import subprocess
import sys
import time
import unittest

import evemu
import machine
import screen_picture
from screen_picture import HEIGHT, WIDTH

LOADED = screen_picture.MESA + [screen_picture.FONT]

# A stroke along a brow and one above it, in which the pen is unplugged, in parts of the window, and frames of each.
BROW = ((0.545, 0.315), (0.604, 0.312), 45)
STROKES = [BROW, ((0.545, 0.290), (0.604, 0.285), 40)]


def ink_on_brow(picture):
    """How many of the places that the pen went over have a colour that neither skin nor hair has."""
    (x0, y0), (x1, y1), count = BROW
    places = [(round((x0 + (x1 - x0) * i / count) * WIDTH), round((y0 + (y1 - y0) * i / count) * HEIGHT)) for i in range(count + 1)]
    return sum(max(picture[y][x]) - min(picture[y][x]) > 110 for x, y in places) / len(places)


class Screen(screen_picture.WindowOnScreen):
    def test_what_the_pen_of_an_event_device_draws_is_seen(self):
        self.assertLess(ink_on_brow(screen_picture.read(SHOT)), 0.1)
        self.assertGreater(ink_on_brow(screen_picture.read(DRAWN)), 0.7)

    def test_the_pen_reaches_nobody_else_while_the_window_has_the_focus(self):
        self.assertEqual(RESULTS['desktop.raw'], b'')

    def test_a_stroke_that_the_unplugging_ends_is_kept(self):
        session = os.path.join(OPTIONS.work, 'drawn.session')
        with open(session, 'wb') as f:
            f.write(RESULTS['drawn.session'])
        told = json.loads(subprocess.run([OPTIONS.penpose, 'replay', session, '--json'], capture_output=True, text=True, check=True).stdout)
        self.assertEqual(told['strokes'], len(STROKES))


def run_machine(options):
    files = {'/traces/pen.evemu': evemu.pen(evemu.drawn_states(STROKES))}
    modules = 'virtio_pci virtio_console bochs hid hid-generic usbhid evdev uinput xhci-pci'.split()
    archive = machine.archive_of(options, 'event_screen', ('virtual_input',), files, modules, LOADED)
    vm = machine.Machine(options.work, archive, memory=1536, processors=2,
                         devices=(f'bochs-display,xres={WIDTH},yres={HEIGHT}', 'usb-tablet,bus=usb.0,id=mouse', 'usb-kbd,bus=usb.0,id=keyboard'))
    shot, drawn = (os.path.join(options.work, name + '.ppm') for name in ('screen', 'drawn'))

    def look_until(path, is_there):
        screen_picture.look_until(vm, path, is_there, 300)
        time.sleep(2)  # a picture that was being drawn is finished
        vm.command('screendump', filename=path)

    try:
        vm.wait_for_mark('started', 200)
        look_until(shot, screen_picture.shows_head)
        vm.command('device_del', id='mouse')
        vm.wait_for_mark('drawn', 200)
        look_until(drawn, lambda picture: ink_on_brow(picture) > 0.7)
        vm.command('device_del', id='keyboard')
        return vm.results(), shot, drawn
    finally:
        vm.end()
        print('\n'.join(l for l in vm.text().splitlines() if 'MARK' in l or 'GAVE UP' in l), flush=True)


OPTIONS = machine.parser_of('penpose', 'tools', 'work').parse_args()
machine.skip_if_missing(LOADED)
RESULTS, SHOT, DRAWN = run_machine(OPTIONS)
Screen.results, Screen.shot = RESULTS, SHOT
unittest.main(argv=[sys.argv[0], '-v'])
