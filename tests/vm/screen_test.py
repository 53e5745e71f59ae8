"""The window on a machine without a desktop, on QEMU's plainest screen: by SDL's KMS/DRM driver and Mesa's software renderer, or
without any OpenGL by the processor.

usage: screen_test.py --penpose PROGRAM --work FOLDER [--way gl|es|cpu|frame_buffer]

es: Mesa offers OpenGL ES 2.0 and nothing else. cpu: there is no OpenGL library. frame_buffer: nor /dev/dri, and the panel is turned by
180 degrees.

The mouse is plugged in when the head is seen: no udev tells the program of it. Looks at what the screen shows and at how the
program ends. Ends with status 77 (skipped) where QEMU, the kernel or Mesa's
files are missing.
"""
import os
import sys
import time
import unittest

import machine
import screen_picture
from screen_picture import FONT, HEIGHT, LEAST_SKIN, MESA, WIDTH

OVERRIDES = {'gl': '', 'es': 'MESA_GL_VERSION_OVERRIDE=1.4 MESA_GLES_VERSION_OVERRIDE=2.0', 'cpu': '', 'frame_buffer': ''}
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
        screen_picture.look_until(vm, shot + '.menu', lambda after: changed_share(before, after) > LEAST_MENU, 20)
        if changed_share(before, screen_picture.read(shot + '.menu')) > LEAST_MENU:
            return


def changed_share(before, after):
    return sum(a != b for row, other in zip(before, after) for a, b in zip(row, other)) / (WIDTH * HEIGHT)


class Screen(screen_picture.WindowOnScreen):
    def test_a_press_on_the_menu_opens_it(self):
        before, after = screen_picture.read(SHOT), screen_picture.read(SHOT + '.menu')
        self.assertGreater(changed_share(before, after), LEAST_MENU)

    def test_the_console_comes_back(self):
        if OPTIONS.way in ('cpu', 'frame_buffer'):
            self.assertLess(screen_picture.skin_in(screen_picture.read(SHOT + '.end')), LEAST_SKIN)


def loaded(options):
    """Files that the program loads by name while it runs."""
    return [FONT] + (MESA if options.way in ('gl', 'es') else [])


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
        screen_picture.look_until(vm, shot, screen_picture.shows_head, 180)
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


parser = machine.parser_of('penpose', 'work')
parser.add_argument('--way', choices=list(OVERRIDES), default='gl')
OPTIONS = parser.parse_args()
machine.skip_if_missing(loaded(OPTIONS))
RESULTS, SHOT = run_machine(OPTIONS)
Screen.results, Screen.shot = RESULTS, SHOT
unittest.main(argv=[sys.argv[0], '-v'])
