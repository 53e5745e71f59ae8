"""Packs the add-on for Blender: pack.py --version V --library SYSTEM=FILE [--library SYSTEM=FILE]... --output ZIP

The zip has one folder, penpose_blender: addon/*.py, penpose's Python side as library/, a C library for each system in a folder of library/
that is named by system, version and hash, and the manifest that Blender 4.2 and later read. Equal inputs give equal bytes.
"""
import argparse
import hashlib
import json
import os
import re
import sys
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = 'penpose_blender'  # not penpose: that is the Python package of the library, which scripts may import beside the add-on
ROOT = os.path.dirname(os.path.dirname(HERE))
# What the file is called where it is loaded from.
LIBRARY = {'linux': 'libpenpose.so.0', 'macos': 'libpenpose.0.dylib', 'windows': 'penpose.dll'}
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
platforms = {platforms}

[permissions]
files = "Write recorded sessions where you choose"
'''


def replaced(pattern, value, text):
    """A text with a value in the one place that a pattern finds."""
    text, found = re.subn(pattern.encode(), value.encode(), text)
    if found != 1:
        sys.exit('pack.py: %s is there %d times, not once' % (pattern, found))
    return text


def main():
    options = argparse.ArgumentParser()
    options.add_argument('--version', required=True)
    options.add_argument('--library', required=True, action='append')
    options.add_argument('--output', required=True)
    given = options.parse_args()
    files = {'LICENSE': os.path.join(ROOT, 'LICENSE')}
    for folder, below in ((os.path.join(HERE, 'addon'), ''), (os.path.join(ROOT, 'ui', 'python', 'penpose'), 'library/')):
        for name in sorted(os.listdir(folder)):
            if name.endswith(('.py', '.typed')):
                files[below + name] = os.path.join(folder, name)
    texts = {}
    for name, path in files.items():
        with open(path, 'rb') as f:
            texts[name] = f.read()
    libraries = {}
    for system, path in (one.split('=', 1) for one in given.library):
        with open(path, 'rb') as f:
            library = f.read()
        folder = '%s-%s-%s' % (system, given.version, hashlib.sha256(library).hexdigest()[:12])
        libraries[system] = (folder, LIBRARY[system.split('-')[0]])
        texts['library/%s/%s' % libraries[system]] = library
    texts['blender_manifest.toml'] = MANIFEST.format(version=given.version, platforms=json.dumps(sorted(libraries))).encode()
    texts['library/_packed.py'] = b"from ..native import path as library\n"
    texts['native.py'] = replaced(r'LIBRARIES = {}', 'LIBRARIES = %s' % dict(sorted(libraries.items())), texts['native.py'])
    version = tuple(map(int, given.version.split('.')))
    texts['__init__.py'] = replaced(r"'version': \([^)]*\)", "'version': %s" % (version,), texts['__init__.py'])
    with zipfile.ZipFile(given.output, 'w', zipfile.ZIP_DEFLATED) as packed:
        # Blender takes away what was installed before only where the zip names the folder itself.
        for name in ['', *sorted(texts)]:
            entry = zipfile.ZipInfo(PACKAGE + '/' + name, (2020, 1, 1, 0, 0, 0))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, (0o644 if name else 0o40755) << 16
            packed.writestr(entry, texts.get(name, b''))


if __name__ == '__main__':
    main()
