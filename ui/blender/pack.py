"""Packs the add-on for Blender: pack.py --version V --system S --machine M --library FILE --output ZIP

The zip has one folder, penpose_blender: addon/*.py, penpose's Python side as penpose/library with the C library and the libraries that this one
needs and systems do not bring, and the manifest that Blender 4.2 and later read. Equal inputs give equal bytes.
"""
import argparse
import os
import re
import subprocess
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = 'penpose_blender'  # not penpose: that is the Python package of the library, which scripts may import beside the add-on
ROOT = os.path.dirname(os.path.dirname(HERE))
# What every system with Blender has.
SYSTEMS = re.compile(r'^(linux-vdso|ld-linux|libc|libm|libdl|libpthread|librt|libgcc_s|libstdc\+\+)[-.]')
PLATFORMS = {('Linux', 'x86_64'): 'linux-x64', ('Linux', 'aarch64'): 'linux-arm64', ('Darwin', 'arm64'): 'macos-arm64',
             ('Darwin', 'x86_64'): 'macos-x64', ('Windows', 'AMD64'): 'windows-x64'}
MANIFEST = '''schema_version = "1.0.0"
id = "penpose_blender"
version = "{version}"
name = "penpose"
tagline = "Pose and rig characters by drawing on them"
maintainer = "The penpose maintainers"
type = "add-on"
blender_version_min = "4.2.0"
license = ["SPDX:MIT"]
tags = ["Animation", "Rigging"]
platforms = ["{platform}"]

[permissions]
files = "Write recorded sessions where you choose"
'''


def needed_by(library):
    """Paths of the libraries that go along."""
    out = subprocess.run(['ldd', library], check=True, capture_output=True, text=True).stdout
    paths = re.findall(r'=> (/\S+)', out)
    return [p for p in paths if not SYSTEMS.match(os.path.basename(p))]


def main():
    options = argparse.ArgumentParser()
    for name in ('version', 'system', 'machine', 'library', 'output'):
        options.add_argument('--' + name, required=True)
    given = options.parse_args()
    files = {}
    for folder, below in ((os.path.join(HERE, 'addon'), ''), (os.path.join(ROOT, 'ui', 'python', 'penpose'), 'library/')):
        for name in sorted(os.listdir(folder)):
            if name.endswith(('.py', '.typed')):
                files[below + name] = os.path.join(folder, name)
    files['library/' + os.path.basename(given.library).split('.so')[0] + '.so.0'] = given.library
    for path in needed_by(given.library):
        files['library/' + os.path.basename(path)] = os.path.realpath(path)
    files['LICENSE'] = os.path.join(ROOT, 'LICENSE')
    platform = PLATFORMS.get((given.system, given.machine), 'linux-x64')
    texts = {'blender_manifest.toml': MANIFEST.format(version=given.version, platform=platform)}
    for name, path in files.items():
        with open(path, 'rb') as f:
            texts[name] = f.read()
    version = tuple(map(int, given.version.split('.')))
    texts['__init__.py'] = re.sub(rb"'version': \([^)]*\)", ("'version': %s" % (version,)).encode(), texts['__init__.py'])
    with zipfile.ZipFile(given.output, 'w', zipfile.ZIP_DEFLATED) as packed:
        for name in sorted(texts):
            entry = zipfile.ZipInfo(PACKAGE + '/' + name, (2020, 1, 1, 0, 0, 0))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            packed.writestr(entry, texts[name])


if __name__ == '__main__':
    main()
