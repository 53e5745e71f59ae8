"""The window on a machine without a desktop, on QEMU's plainest screen: by SDL's KMS/DRM driver and Mesa's software renderer, or
without any OpenGL by the processor.

usage: screen_test.py --penpose PROGRAM --work FOLDER [--way gl|es|cpu|frame_buffer]

es: Mesa offers OpenGL ES 2.0 and nothing else. cpu: there is no OpenGL library. frame_buffer: nor /dev/dri, and the panel is turned by
180 degrees.

The mouse is plugged in when the head is seen: no udev tells the program of it. Looks at what the screen shows and at how the
program ends. Ends with status 77 (skipped) where QEMU, the kernel or Mesa's
files are missing.
"""
import argparse
import os
import sys
import time
import unittest

import machine
import screen_picture

LIBRARIES = '/usr/lib/x86_64-linux-gnu/'
LOADED = [LIBRARIES + name for name in ('libgbm.so.1', 'libdrm.so.2', 'libEGL.so.1', 'libEGL_mesa.so.0', 'libGL.so.1', 'libOpenGL.so.0',
                                        'libGLX_mesa.so.0', 'dri/kms_swrast_dri.so')]
LOADED += ['/usr/share/glvnd/egl_vendor.d/50_mesa.json']

FONT = '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf'
OVERRIDES = {'gl': '', 'es': 'MESA_GL_VERSION_OVERRIDE=1.4 MESA_GLES_VERSION_OVERRIDE=2.0', 'cpu': '', 'frame_buffer': ''}
WIDTH, HEIGHT = 640, 480
LEAST_SHADES = 1000
LEAST_SKIN = 0.02
LEAST_MENU = 0.1


def menu_pressed(options):
    """What QEMU's mouse sends for a press on the menu, at the upper left of an upright panel: far into that corner, and back a little."""
    back = -1 if options.way == 'frame_buffer' else 1
    for x, y in ((-2000 * back, -2000 * back), (30 * back, 20 * back)):
        yield [{'type': 'rel', 'data': {'axis': axis, 'value': value}} for axis, value in (('x', x), ('y', y))]
    for down in (True, False):
        yield [{'type': 'btn', 'data': {'button': 'left', 'down': down}}]


def press_until_the_menu_opens(vm, options, shot):
    """Leaves what the screen shows then in SHOT.menu. QEMU drops what its mouse sends before the kernel's driver has asked for it, which
    may be after the first picture: as a person would, it presses again."""
    before = screen_picture.read(shot)
    for _ in range(4):
        for event in menu_pressed(options):
            vm.command('input-send-event', events=event)
            time.sleep(1)
        until = time.monotonic() + 20
        while time.monotonic() < until:
            time.sleep(2)
            vm.command('screendump', filename=shot + '.menu')
            if changed_share(before, screen_picture.read(shot + '.menu')) > LEAST_MENU:
                return


def shades_of(picture):
    return {p for row in picture for p in row}


def changed_share(before, after):
    return sum(a != b for row, other in zip(before, after) for a, b in zip(row, other)) / (WIDTH * HEIGHT)


class Screen(unittest.TestCase):
    def test_the_head_is_seen_between_the_panels(self):
        picture = screen_picture.read(SHOT)
        self.assertEqual((len(picture[0]), len(picture)), (WIDTH, HEIGHT))
        self.assertGreater(len(shades_of(picture)), LEAST_SHADES)
        self.assertGreater(screen_picture.skin_in(picture), LEAST_SKIN)
        self.assertLess(screen_picture.skin_in(picture), 0.5)

    def test_a_press_on_the_menu_opens_it(self):
        before, after = screen_picture.read(SHOT), screen_picture.read(SHOT + '.menu')
        self.assertGreater(changed_share(before, after), LEAST_MENU)

    def test_the_console_comes_back(self):
        if OPTIONS.way in ('cpu', 'frame_buffer'):
            self.assertLess(screen_picture.skin_in(screen_picture.read(SHOT + '.end')), LEAST_SKIN)

    def test_a_polite_end_is_an_orderly_one(self):
        self.assertEqual(RESULTS['status'].decode().strip(), '0', RESULTS.get('app.txt', b'').decode())
        self.assertIn('# penpose', RESULTS['drawn.session'].decode())


def loaded(options):
    """Files that the program loads by name while it runs."""
    return [FONT] + (LOADED if options.way in ('gl', 'es') else [])


def run_machine(options):
    os.makedirs(options.work, exist_ok=True)
    with open(os.path.join(machine.HERE, 'guest/screen.sh'), encoding='utf-8') as f:
        files = {'/job.sh': f.read(), '/way': options.way, '/overrides': OVERRIDES[options.way]}
    modules = 'virtio_pci virtio_console bochs hid hid-generic usbhid evdev xhci-pci'.split()
    archive = machine.build_initramfs(options.work, [options.penpose], files, modules, loaded(options))
    vm = machine.Machine(options.work, archive, memory=1536, processors=2,
                         devices=(f'bochs-display,xres={WIDTH},yres={HEIGHT}', 'usb-kbd,bus=usb.0,port=2,id=keyboard'))
    shot = os.path.join(options.work, 'screen.ppm')
    try:
        vm.wait_for_mark('started', 200)
        until = time.monotonic() + 180
        while time.monotonic() < until:
            time.sleep(2)
            vm.command('screendump', filename=shot)
            if screen_picture.skin_in(screen_picture.read(shot)) > LEAST_SKIN:
                break
        time.sleep(2)
        vm.command('screendump', filename=shot)
        vm.command('device_add', driver='usb-mouse', bus='usb.0', port='1', id='mouse')
        time.sleep(2)
        press_until_the_menu_opens(vm, options, shot)
        vm.command('device_del', id='mouse')
        vm.wait_for_mark('ended', 60)
        time.sleep(1)
        vm.command('screendump', filename=shot + '.end')
        vm.command('device_del', id='keyboard')
        return vm.results(), shot
    finally:
        vm.end()


parser = argparse.ArgumentParser()
parser.add_argument('--penpose', required=True)
parser.add_argument('--work', required=True)
parser.add_argument('--way', choices=list(OVERRIDES), default='gl')
OPTIONS = parser.parse_args()
machine.skip_if_missing(loaded(OPTIONS))
RESULTS, SHOT = run_machine(OPTIONS)
unittest.main(argv=[sys.argv[0], '-v'])
