"""The window on a machine without a desktop: SDL's KMS/DRM driver and Mesa's software renderer on QEMU's plainest screen. A pen
that has an event device alone draws in it.

usage: screen_test.py --penpose PROGRAM --tools FOLDER --work FOLDER

Looks at what the screen shows and at how the program ends. Ends with status 77 (skipped) where QEMU, the kernel or Mesa's
files are missing.
"""
import argparse
import json
import os
import subprocess
import sys
import time
import unittest

import evemu
import machine

LIBRARIES = '/usr/lib/x86_64-linux-gnu/'
LOADED = [LIBRARIES + name for name in ('libgbm.so.1', 'libdrm.so.2', 'libEGL.so.1', 'libEGL_mesa.so.0', 'libGL.so.1', 'libOpenGL.so.0',
                                        'libGLX_mesa.so.0', 'dri/kms_swrast_dri.so')]
LOADED += ['/usr/share/glvnd/egl_vendor.d/50_mesa.json', '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf']
WIDTH, HEIGHT = 640, 480
LEAST_SHADES = 1000
LEAST_SKIN = 0.02
# A stroke along a brow and one above it, in which the pen is unplugged, in parts of the window, and frames of each.
BROW = ((0.395, 0.315), (0.460, 0.315), 45)
STROKES = [BROW, ((0.395, 0.290), (0.460, 0.285), 40)]


def picture_of(path):
    """The pixels of a binary PPM, rows of (red, green, blue)."""
    with open(path, 'rb') as f:
        content = f.read()
    width, height = (int(word) for word in content.split(maxsplit=3)[1:3])
    pixels = content[-3 * width * height:]
    return [[tuple(pixels[3 * (y * width + x):3 * (y * width + x) + 3]) for x in range(width)] for y in range(height)]


def skin_in(picture):
    """The share of pixels of the head's skin: redder than blue by far, which panels and background are not."""
    return sum(r > b + 30 and r > 100 for row in picture for r, g, b in row) / (WIDTH * HEIGHT)


def ink_on_brow(picture):
    """How many of the places that the pen went over have a colour that neither skin nor hair has."""
    (x0, y0), (x1, y1), count = BROW
    places = [(round((x0 + (x1 - x0) * i / count) * WIDTH), round((y0 + (y1 - y0) * i / count) * HEIGHT)) for i in range(count + 1)]
    return sum(max(picture[y][x]) - min(picture[y][x]) > 110 for x, y in places) / len(places)


def shades_of(picture):
    return {p for row in picture for p in row}


class Screen(unittest.TestCase):
    def test_the_head_is_seen_between_the_panels(self):
        picture = picture_of(SHOT)
        self.assertEqual((len(picture[0]), len(picture)), (WIDTH, HEIGHT))
        self.assertGreater(len(shades_of(picture)), LEAST_SHADES)
        self.assertGreater(skin_in(picture), LEAST_SKIN)
        self.assertLess(skin_in(picture), 0.5)

    def test_what_the_pen_of_an_event_device_draws_is_seen(self):
        self.assertLess(ink_on_brow(picture_of(SHOT)), 0.1)
        self.assertGreater(ink_on_brow(picture_of(DRAWN)), 0.7)

    def test_the_pen_reaches_nobody_else_while_the_window_has_the_focus(self):
        self.assertEqual(RESULTS['desktop.raw'], b'')

    def test_a_stroke_that_the_unplugging_ends_is_kept(self):
        session = os.path.join(OPTIONS.work, 'drawn.session')
        with open(session, 'wb') as f:
            f.write(RESULTS['drawn.session'])
        told = json.loads(subprocess.run([OPTIONS.penpose, 'replay', session, '--json'], capture_output=True, text=True, check=True).stdout)
        self.assertEqual(told['strokes'], len(STROKES))

    def test_a_polite_end_is_an_orderly_one(self):
        self.assertEqual(RESULTS['status'].decode().strip(), '0', RESULTS.get('app.txt', b'').decode())
        self.assertIn('# penpose', RESULTS['drawn.session'].decode())


def run_machine(options):
    os.makedirs(options.work, exist_ok=True)
    with open(os.path.join(machine.HERE, 'guest/screen.sh'), encoding='utf-8') as f:
        files = {'/job.sh': f.read(), '/traces/pen.evemu': evemu.pen(evemu.drawn_states(STROKES))}
    modules = 'virtio_pci virtio_console bochs hid hid-generic usbhid evdev uinput xhci-pci'.split()
    programs = [options.penpose, os.path.join(options.tools, 'virtual_input')]
    archive = machine.build_initramfs(options.work, programs, files, modules, LOADED)
    vm = machine.Machine(options.work, archive, memory=1536, processors=2,
                         devices=(f'bochs-display,xres={WIDTH},yres={HEIGHT}', 'usb-tablet,bus=usb.0,id=mouse', 'usb-kbd,bus=usb.0,id=keyboard'))
    shot, drawn = (os.path.join(options.work, name + '.ppm') for name in ('screen', 'drawn'))

    def look_until(path, is_there):
        until = time.monotonic() + 300
        while time.monotonic() < until:
            time.sleep(2)
            vm.command('screendump', filename=path)
            if is_there(picture_of(path)):
                break
        time.sleep(2)  # a picture that was being drawn is finished
        vm.command('screendump', filename=path)

    try:
        vm.wait_for_mark('started', 200)
        look_until(shot, lambda picture: skin_in(picture) > LEAST_SKIN)
        vm.command('device_del', id='mouse')
        vm.wait_for_mark('drawn', 200)
        look_until(drawn, lambda picture: ink_on_brow(picture) > 0.7)
        vm.command('device_del', id='keyboard')
        return vm.results(), shot, drawn
    finally:
        vm.end()
        print('\n'.join(l for l in vm.text().splitlines() if 'MARK' in l or 'GAVE UP' in l), flush=True)


parser = argparse.ArgumentParser()
for option in ('penpose', 'tools', 'work'):
    parser.add_argument('--' + option, required=True)
OPTIONS = parser.parse_args()
machine.skip_if_missing(LOADED)
RESULTS, SHOT, DRAWN = run_machine(OPTIONS)
unittest.main(argv=[sys.argv[0], '-v'])
