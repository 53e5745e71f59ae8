#!/usr/bin/env python3
"""The udev rule as udev itself applies it: tablets that umockdev makes up get the tag `uaccess`, strangers get nothing. No root is
needed: the rule takes the place of the system's in a mount namespace of this test alone.

usage: udev_rule_test.py --penpose PROGRAM --work FOLDER"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import unittest

# Name, vendor, product, whether the rule is for it.
DEVICES = [('a Wacom', '056a', '00b8', True), ('a Wacom that is not in the table', '056a', '0fff', True),
           ('a Huion', '256c', '006d', True), ('an XP-Pen', '28bd', '0094', True),
           ('a keyboard', '046d', 'c31c', False), ('something else by the maker of the Huion', '256c', '0999', False),
           ('one whose product is the vendor of tablets', '046d', '056a', False)]
FOLDERS = [f for f in ('/usr/lib/udev/rules.d', '/etc/udev/rules.d') if os.path.isdir(f)]


def described(number, vendor, product):
    """A USB device, its interface, the HID device and its node, in umockdev's form; and the paths of the two with nodes."""
    port = f'1-{number + 1}'
    usb = f'/devices/pci0000:00/0000:00:03.0/usb1/{port}'
    hid = f'{usb}/{port}:1.0/0003:{vendor.upper()}:{product.upper()}.{number + 1:04X}'
    node = f'{hid}/hidraw/hidraw{number}'
    text = f'''P: {usb}
N: bus/usb/001/{number + 2:03}
E: DEVNAME=/dev/bus/usb/001/{number + 2:03}
E: DEVTYPE=usb_device
E: SUBSYSTEM=usb
A: idVendor={vendor}\\n
A: idProduct={product}\\n

P: {usb}/{port}:1.0
E: DEVTYPE=usb_interface
E: SUBSYSTEM=usb

P: {hid}
E: SUBSYSTEM=hid

P: {node}
N: hidraw{number}
E: DEVNAME=/dev/hidraw{number}
E: SUBSYSTEM=hidraw

'''
    return text, (usb, node)


class UdevRule(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(OPTIONS.work, ignore_errors=True)
        cls.rules = os.path.join(OPTIONS.work, 'rules')
        os.makedirs(cls.rules)
        subprocess.run([OPTIONS.penpose, 'devices', '--install-udev-rule', '--rules-folder', cls.rules], check=True, stdout=subprocess.DEVNULL)
        parts = [described(i, vendor, product) for i, (_, vendor, product, _) in enumerate(DEVICES)]
        cls.paths = [paths for _, paths in parts]
        cls.description = os.path.join(OPTIONS.work, 'devices.umockdev')
        with open(cls.description, 'w', encoding='utf-8') as f:
            f.write(''.join(text for text, _ in parts))

    def said_of(self, path, action):
        """What `udevadm test` says of a device."""
        script = ''.join(f'mount --bind "$1" {folder} && ' for folder in FOLDERS)
        # What udev remembers of devices is neither seen nor touched.
        script += 'mount -t tmpfs none /run && '
        script += 'exec umockdev-run --device "$2" -- udevadm test --action="$3" "/sys$4" 2>&1'
        done = subprocess.run(['unshare', '--map-root-user', '--mount', 'sh', '-c', script, 'sh', self.rules, self.description, action, path],
                              capture_output=True, text=True)
        self.assertIn('DEVPATH=' + path, done.stdout, done.stderr)
        return done.stdout

    @staticmethod
    def tags(said):
        found = re.search(r'^TAGS=(.*)$', said, re.M)
        return set(found.group(1).strip(':').split(':')) if found else set()

    def test_tablets_get_access_and_strangers_get_nothing(self):
        for (name, _, _, wanted), paths in zip(DEVICES, self.paths):
            for path in paths:
                with self.subTest(f'{name}: {path}'):
                    said = self.said_of(path, 'add')
                    self.assertEqual(self.tags(said), {'uaccess'} if wanted else set())
                    # Who owns a node and who else may open it stays as it was.
                    self.assertNotRegex(said, r'(MODE|GROUP|OWNER) \d')

    def test_udev_has_nothing_to_say_against_it(self):
        said = self.said_of(self.paths[0][0], 'add')
        self.assertIn('70-penpose.rules', said)
        for line in said.splitlines():
            if '70-penpose.rules' in line:
                self.assertNotRegex(line, r'(?i)invalid|unknown|ignor|fail|error|unexpected|overlong')

    def test_what_is_unplugged_is_left_alone(self):
        self.assertEqual(self.tags(self.said_of(self.paths[0][1], 'remove')), set())


parser = argparse.ArgumentParser()
for option in ('penpose', 'work'):
    parser.add_argument('--' + option, required=True)
OPTIONS = parser.parse_args()
MISSING = [package for program, package in (('udevadm', 'udev'), ('umockdev-run', 'umockdev')) if not shutil.which(program)]
if MISSING:
    print(f'SKIPPED: the rule is not applied without these packages; install them with: apt-get install {" ".join(MISSING)}')
    sys.exit(77)
if subprocess.run(['unshare', '--map-root-user', '--mount', 'true'], capture_output=True).returncode != 0:
    print('SKIPPED: the system lets this user make no mount namespace (in a container: start it with --security-opt seccomp=unconfined)')
    sys.exit(77)
unittest.main(argv=sys.argv[:1], verbosity=2)
