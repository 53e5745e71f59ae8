#!/usr/bin/env python3
"""recipes_test.py SOURCE FOLDER: the recipes of Buildroot and Yocto name the options and the libraries that a configured build has.

Each choice that they offer is configured in FOLDER with the options of the recipe; what CMake looked for must be what the recipe
depends on. Neither Buildroot nor Yocto is run."""
import os
import re
import subprocess
import sys
import unittest

SOURCE, FOLDER = (os.path.abspath(path) for path in sys.argv[1:3])
BOARDS = os.path.join(SOURCE, 'ui/install/boards')
# What CMake or pkg-config calls a library: the packages of Buildroot and of Yocto's layers.
PACKAGES = {
    'CLI11': ('cli11', 'cli11'), 'JPEG': ('jpeg', 'jpeg'), 'PNG': ('libpng', 'libpng'), 'ZLIB': ('zlib', 'zlib'), 'glm': ('glm', 'glm'),
    'meshoptimizer': ('meshoptimizer', 'meshoptimizer'), 'draco': ('draco', 'draco'), 'libwebp': ('webp', 'libwebp'),
    'libxxhash': ('xxhash', 'xxhash'), 'libevdev': ('libevdev', 'libevdev'), 'hidapi-hidraw': ('hidapi', 'hidapi'),
    'libusb-1.0': ('libusb', 'libusb1'), 'sdl2': ('sdl2', 'libsdl2'), 'fontconfig': ('fontconfig', 'fontconfig'),
    'libdrm': ('libdrm', 'libdrm'), 'pugixml': ('pugixml', 'pugixml'), 'epoxy': ('libepoxy', 'libepoxy'),
    # Buildroot has no package of it.
    'imgui': (None, 'imgui')}
# A header without a file for CMake, and what every recipe needs to configure.
UNSEEN = {'tinygltf', 'host-pkgconf'}
NO_LIBRARIES = {'PkgConfig', 'Threads'}
CHOICES = [(), ('DEVICES',), ('DEVICES', 'LIBUSB'), ('DEVICES', 'WINDOW'), ('WINDOW',), ('DEVICES', 'WINDOW', 'GL'),
           ('DEVICES', 'LIBUSB', 'WINDOW', 'GL')]


def read(path):
    with open(os.path.join(SOURCE, path), encoding='utf-8') as f:
        return f.read().replace('\\\n', ' ')


def buildroot(choices):
    """(options, packages) of the Buildroot recipe."""
    text = read('ui/install/boards/buildroot/package/penpose/penpose.mk')
    chosen = {'BR2_PACKAGE_PENPOSE_' + choice for choice in choices}
    text = re.sub(r'\$\(call penpose_onoff,(\w+)\)', lambda m: 'ON' if m[1] in chosen else 'OFF', text)
    text = re.sub(r'\$\(if \$\((\w+)\),([^()]*)\)', lambda m: m[2] if m[1] in chosen else '', text)
    options = re.search(r'^PENPOSE_CONF_OPTS =(.*)$', text, re.M)[1].split()
    return options, set(' '.join(re.findall(r'^PENPOSE_DEPENDENCIES \+?=(.*)$', text, re.M)).split())


def selected(choices):
    """The packages that Buildroot's menu selects."""
    found, on, menu = set(), False, read('ui/install/boards/buildroot/package/penpose/Config.in')
    for line in menu.splitlines():
        words = line.split()
        if words[:1] == ['config']:
            name = words[1].removeprefix('BR2_PACKAGE_PENPOSE').lstrip('_')
            on = not name or name in choices
        elif words[:1] == ['select'] and on and 'if' not in words:
            found.add(words[1].removeprefix('BR2_PACKAGE_').lower())
    return found


def yocto(choices):
    """(options, packages) of the Yocto recipe."""
    text = read('ui/install/boards/yocto/penpose.bb')
    options = re.search(r'^EXTRA_OECMAKE = "(.*)"$', text, re.M)[1].split()
    packages = set(re.search(r'^DEPENDS = "(.*)"$', text, re.M)[1].split())
    for name, on, off, needs in re.findall(r'^PACKAGECONFIG\[(\w+)\] = "([^,]*),([^,]*),([^"]*)"$', text, re.M):
        chosen = name.upper() in choices
        options.append(on if chosen else off)
        packages |= set(needs.split()) if chosen else set()
    return options, packages


def looked_for(name, options):
    """The libraries that CMake finds with these options, by its own or pkg-config's names."""
    build = os.path.join(FOLDER, name)
    run = subprocess.run(['cmake', '-S', SOURCE, '-B', build, '-G', 'Ninja', '--fresh', *options], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert 'not used by the project' not in run.stderr, run.stderr
    with open(os.path.join(build, 'CMakeCache.txt'), encoding='utf-8') as f:
        cache = f.read()
    found = set(re.findall(r'^\w+_MODULE_NAME:INTERNAL=(.*)$', cache, re.M))
    found |= set(re.findall(r'^FIND_PACKAGE_MESSAGE_DETAILS_(\w+):', cache, re.M))
    found |= {name for name in re.findall(r'^(\w+)_DIR:PATH=/', cache, re.M) if not name.endswith('_INCLUDE')}
    return found - NO_LIBRARIES


class Recipes(unittest.TestCase):
    def compare(self, name, column, options, packages):
        wanted = {PACKAGES[library][column] for library in looked_for(name, options)} - {None}
        self.assertEqual(packages - UNSEEN, wanted)

    def test_buildroot(self):
        for choices in CHOICES:
            with self.subTest(choices):
                options, packages = buildroot(choices)
                self.compare('buildroot', 0, options, packages)
                self.assertEqual(selected(choices), packages - {'host-pkgconf'}, 'Config.in selects others than penpose.mk depends on')

    def test_yocto(self):
        for choices in CHOICES:
            with self.subTest(choices):
                self.compare('yocto', 1, *yocto(choices))


unittest.main(argv=sys.argv[:1], verbosity=2)
