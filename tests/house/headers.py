#!/usr/bin/env python3
"""Every public header compiles alone, with no more before it than its module may include.

A header with a source of its name is shown to do so wherever that source is compiled by itself (tests/golden/matrix.sh; the
presets without PENPOSE_UNITY), as the source includes it first. The others are compiled here.

usage: headers.py CLANG MODULES_FOLDER     MODULES_FOLDER holds a file a module: its include folders in one line, divided by
semicolons, and then a header a line."""
import concurrent.futures
import os
import re
import subprocess
import sys

clang, modules = sys.argv[1:]


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def first_include(source):
    found = re.search(r'^#include ["<]([^">]*)', read(source), re.M)
    return found.group(1) if found else ''


def compiled(header, folders):
    run = subprocess.run([clang, '-std=c++20', '-fsyntax-only', '-Wno-pragma-once-outside-header', *['-I' + folder for folder in folders],
                          '-x', 'c++', header], capture_output=True, text=True, check=False)
    return run.stderr if run.returncode else ''


def main():
    faults, jobs, count = [], [], 0
    for name in sorted(os.listdir(modules)):
        folders, *headers = read(os.path.join(modules, name)).split('\n')
        folders = [folder for folder in folders.split(';') if folder]
        for header in filter(None, headers):
            count += 1
            source = header.removesuffix('.h') + '.cpp'
            has_source = os.path.exists(source)
            if has_source and not header.endswith('/' + first_include(source)):
                faults.append(source + ': include its own header first')
            if not has_source:
                jobs.append((header, folders))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults += filter(None, pool.map(lambda job: compiled(*job), jobs))
    print('\n'.join(faults))
    print('%d headers, %d compiled here, %d faults' % (count, len(jobs), len(faults)))
    return 1 if faults or not jobs else 0


sys.exit(main())
