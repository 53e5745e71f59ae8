"""The window on a machine without a desktop: SDL's KMS/DRM driver and Mesa's software renderer on QEMU's plainest screen.

usage: screen_test.py --penpose PROGRAM --work FOLDER

Looks at what the screen shows and at how the program ends. Ends with status 77 (skipped) where QEMU, the kernel or Mesa's
files are missing.
"""
import argparse
import os
import sys
import time
import unittest

import machine

LIBRARIES = '/usr/lib/x86_64-linux-gnu/'
LOADED = [LIBRARIES + name for name in ('libgbm.so.1', 'libdrm.so.2', 'libEGL.so.1', 'libEGL_mesa.so.0', 'libGL.so.1', 'libOpenGL.so.0',
                                        'libGLX_mesa.so.0', 'dri/kms_swrast_dri.so')]
LOADED += ['/usr/share/glvnd/egl_vendor.d/50_mesa.json', '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf']
WIDTH, HEIGHT = 640, 480
LEAST_SHADES = 1000
LEAST_SKIN = 0.02


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


def shades_of(picture):
    return {p for row in picture for p in row}


class Screen(unittest.TestCase):
    def test_the_head_is_seen_between_the_panels(self):
        picture = picture_of(SHOT)
        self.assertEqual((len(picture[0]), len(picture)), (WIDTH, HEIGHT))
        self.assertGreater(len(shades_of(picture)), LEAST_SHADES)
        self.assertGreater(skin_in(picture), LEAST_SKIN)
        self.assertLess(skin_in(picture), 0.5)

    def test_a_polite_end_is_an_orderly_one(self):
        self.assertEqual(RESULTS['status'].decode().strip(), '0', RESULTS.get('app.txt', b'').decode())
        self.assertIn('# penpose', RESULTS['drawn.session'].decode())


def run_machine(options):
    os.makedirs(options.work, exist_ok=True)
    with open(os.path.join(machine.HERE, 'guest/screen.sh'), encoding='utf-8') as f:
        files = {'/job.sh': f.read()}
    modules = 'virtio_pci virtio_console bochs hid hid-generic usbhid evdev xhci-pci'.split()
    archive = machine.build_initramfs(options.work, [options.penpose], files, modules, LOADED)
    vm = machine.Machine(options.work, archive, memory=1536, processors=2,
                         devices=(f'bochs-display,xres={WIDTH},yres={HEIGHT}', 'usb-tablet,bus=usb.0,id=mouse', 'usb-kbd,bus=usb.0'))
    shot = os.path.join(options.work, 'screen.ppm')
    try:
        vm.wait_for_mark('started', 200)
        until = time.monotonic() + 180
        while time.monotonic() < until:
            time.sleep(2)
            vm.command('screendump', filename=shot)
            if skin_in(picture_of(shot)) > LEAST_SKIN:
                break
        time.sleep(2)  # a picture that was being drawn is finished
        vm.command('screendump', filename=shot)
        vm.command('device_del', id='mouse')
        return vm.results(), shot
    finally:
        vm.end()


parser = argparse.ArgumentParser()
parser.add_argument('--penpose', required=True)
parser.add_argument('--work', required=True)
OPTIONS = parser.parse_args()
machine.skip_if_missing(LOADED)
RESULTS, SHOT = run_machine(OPTIONS)
unittest.main(argv=[sys.argv[0], '-v'])
