#!/usr/bin/env python3
"""The libraries are installed into an empty folder, and programs that know nothing else find them there. Each replays the project's own
sessions to their golden states, and all come to the same pose."""
import argparse
import os
import shutil
import sys

from running import run

SESSIONS = ('ui/demo/demo.session', 'tests/data/sessions/penpartner.session',
            'tests/data/sessions/suggest.session@tests/data/models/test_sheet.glb')


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ('cmake', 'build', 'source', 'cxx', 'work'):
        parser.add_argument('--' + name, required=True)
    arguments = parser.parse_args()
    source, work = arguments.source, arguments.work
    shutil.rmtree(work, ignore_errors=True)
    prefix = os.path.join(work, 'prefix')
    for component in ('libpenpose0', 'libpenpose-dev', 'python3-penpose'):
        run(arguments.cmake, '--install', arguments.build, '--prefix', prefix, '--component', component)
    lib = os.path.join(prefix, 'lib')
    for folder, _, files in os.walk(prefix):
        if 'libpenpose.so.0' in files:
            lib = folder
    with open(os.path.join(source, 'tests/golden/hashes.txt'), encoding='utf-8') as file:
        golden = dict(line.split() for line in file)
    sessions = ['@'.join(os.path.join(source, piece) for piece in path.split('@')) for path in SESSIONS]
    names = [os.path.basename(path.split('@')[0]) for path in SESSIONS]
    expected = ['%s %s' % (name, golden[name]) for name in names]

    here = os.path.dirname(os.path.abspath(__file__))
    compilers = {'c': [], 'cpp': ['-DCMAKE_CXX_COMPILER=' + arguments.cxx]}
    poses = set()

    def check(name, said):
        lines = said.splitlines()
        if lines[:-1] != expected or not lines[-1].startswith('pose '):
            sys.exit('%s says\n%s\nand not\n%s' % (name, said, '\n'.join(expected)))
        poses.add(lines[-1])
        print(name, lines[-1])

    for name in ('c', 'cpp'):
        out = os.path.join(work, name)
        run(arguments.cmake, '-S', os.path.join(here, name), '-B', out, '-DCMAKE_PREFIX_PATH=' + prefix, '-DCMAKE_BUILD_TYPE=Release',
            *compilers[name])
        run(arguments.cmake, '--build', out)
        check(name, run(os.path.join(out, 'in_' + name), *sessions))
    print('decode', run(os.path.join(work, 'cpp', 'samples')).strip())
    # As a compiler without CMake finds it.
    flags = run('pkg-config', '--cflags', '--libs', 'penpose', env=dict(os.environ, PKG_CONFIG_PATH=os.path.join(lib, 'pkgconfig')))
    plain = os.path.join(work, 'plain')
    run('cc', '-std=c99', '-o', plain, os.path.join(here, 'c', 'main.c'), *flags.split(), '-lm', '-Wl,-rpath,' + lib)
    check('pkg-config', run(plain, *sessions))

    script = os.path.join(here, 'in_python.py')
    environment = {key: value for key, value in os.environ.items() if not key.startswith('PYTHON') and key != 'PENPOSE_LIBRARY'}
    environment['PYTHONDONTWRITEBYTECODE'] = '1'
    installed = os.path.join(prefix, 'lib/python3/dist-packages')
    check('python', run('/usr/bin/python3', script, *sessions, env=dict(environment, PYTHONPATH=installed)))
    # From the source tree, with setuptools alone: nothing is looked for elsewhere.
    tree, target = os.path.join(work, 'tree'), os.path.join(work, 'pip')
    shutil.copytree(os.path.join(source, 'ui/python'), tree)
    run('/usr/bin/python3', '-m', 'pip', 'install', '--no-build-isolation', '--no-deps', '--no-index', '--target', target, tree)
    check('pip', run('/usr/bin/python3', script, *sessions, env=dict(environment, PYTHONPATH=target, LD_LIBRARY_PATH=lib)))
    if len(poses) != 1:
        sys.exit('the poses differ: %s' % sorted(poses))
    return 0


if __name__ == '__main__':
    sys.exit(main())
