#!/usr/bin/env python3
"""clang-tidy over every source of the product. A file is looked at again only when it, a header or the rules changed.

usage: tidy.py CLANG_TIDY SOURCE_FOLDER BUILD_FOLDER"""
import concurrent.futures
import hashlib
import json
import os
import subprocess
import sys

tool, root, build = sys.argv[1:]
root = os.path.realpath(root)
cache = os.path.join(build, 'tidy_cache')
os.makedirs(cache, exist_ok=True)


def read(path):
    with open(path, 'rb') as f:
        return f.read()


shared = hashlib.sha256(read(os.path.join(root, '.clang-tidy')))
for module in ('core', 'firmware_io', 'replay', 'ui'):
    for folder, folders, names in sorted(os.walk(os.path.join(root, module))):
        for name in sorted(names):
            if name.endswith('.h'):
                shared.update(read(os.path.join(folder, name)))
files = sorted({os.path.realpath(os.path.join(e['directory'], e['file'])) for e in json.load(open(os.path.join(build, 'compile_commands.json')))})
files = [f for f in files if os.path.relpath(f, root).split(os.sep)[0] in ('core', 'firmware_io', 'replay', 'ui')]


def check(path):
    key = hashlib.sha256(shared.digest() + read(path)).hexdigest()
    done = os.path.join(cache, key)
    if os.path.exists(done):
        return 0, ''
    # The compile commands may be GCC's; Clang does not know all of its warnings.
    run = subprocess.run([tool, '-p', build, '--quiet', '--extra-arg=-Wno-unknown-warning-option', '--extra-arg=-Wno-everything', path],
                         capture_output=True, text=True)
    if run.returncode == 0:
        open(done, 'w').close()
    return run.returncode, run.stdout


status = 0
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for code, text in pool.map(check, files):
        if code:
            status = 1
            print(text)
print('%d files' % len(files))
sys.exit(status)
