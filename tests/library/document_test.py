#!/usr/bin/env python3
"""The examples of docs/library.md, as they stand there: built or run with the installed libraries, all say the same, and each line of the
conversation is answered with yes. The script that it names poses the head and plots what is left."""
import argparse
import json
import os
import re
import sys

from running import run


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ('cmake', 'source', 'cxx', 'installed', 'penpose', 'work'):
        parser.add_argument('--' + name, required=name != 'penpose')
    arguments = parser.parse_args()
    with open(os.path.join(arguments.source, 'docs/library.md'), encoding='utf-8') as file:
        blocks = dict((kind or 'talk', text) for kind, text in re.findall(r'^```(\w*)\n(.*?)^```$', file.read(), re.M | re.S))
    prefix, work = os.path.join(arguments.installed, 'prefix'), arguments.work
    lib = next(folder for folder, _, files in os.walk(prefix) if 'libpenpose.so.0' in files)
    os.makedirs(os.path.join(work, 'build'), exist_ok=True)
    for name, kind in (('pose.c', 'c'), ('pose.cpp', 'cpp'), ('CMakeLists.txt', 'cmake'), ('pose.py', 'python')):
        with open(os.path.join(work, name), 'w', encoding='utf-8') as file:
            file.write(blocks[kind])
    include = [folder for folder, _, files in os.walk(prefix) if 'penpose.h' in files][0]
    run('cc', '-std=c99', '-Wall', '-Werror', '-o', os.path.join(work, 'in_c'), os.path.join(work, 'pose.c'), '-I' + include, '-L' + lib,
        '-lpenpose', '-Wl,-rpath,' + lib)
    run(arguments.cmake, '-S', work, '-B', os.path.join(work, 'build'), '-DCMAKE_PREFIX_PATH=' + prefix,
        '-DCMAKE_CXX_COMPILER=' + arguments.cxx)
    run(arguments.cmake, '--build', os.path.join(work, 'build'))
    python = dict(os.environ, PYTHONPATH=os.path.join(prefix, 'lib/python3/dist-packages'), PYTHONDONTWRITEBYTECODE='1')
    said = {run(os.path.join(work, 'in_c')), run(os.path.join(work, 'build', 'pose')),
            run('/usr/bin/python3', os.path.join(work, 'pose.py'), env=python)}
    print(''.join(said), end='')
    if said != {'0.0 mm of 2 mm left\n'}:
        sys.exit('the examples do not end with what was asked for')
    plot = os.path.join(work, 'residual.png')
    told = run('/usr/bin/python3', os.path.join(arguments.source, 'ui/python/examples/pose_the_head.py'), plot, env=python)
    if [line.split()[0] for line in told.splitlines()[1:]] != ['default', 'exact', 'paper']:
        sys.exit('the script says\n' + told)
    with open(plot, 'rb') as file:
        head = file.read(24)
    width, height = int.from_bytes(head[16:20], 'big'), int.from_bytes(head[20:24], 'big')
    if head[:8] != b'\x89PNG\r\n\x1a\n' or width < 1000 or height < 300:
        sys.exit('the plot is no picture of %d x %d px' % (width, height))
    if arguments.penpose:
        session = os.path.join(work, 'talk.session')
        if os.path.exists(session):
            os.remove(session)
        answers = run(arguments.penpose, 'serve', '--session', session, input=blocks['talk']).splitlines()
        asked = blocks['talk'].splitlines()
        wrong = [line for line, answer in zip(asked, answers) if not json.loads(answer)['ok']]
        if wrong or len(answers) != len(asked):
            sys.exit('not answered: %s\n%s' % (wrong, '\n'.join(answers)[:2000]))
        replayed = json.loads(run(arguments.penpose, 'replay', session, '--json'))
        if replayed['state'] != json.loads(answers[-1])['state'] or replayed['differing'] or not replayed['checked']:
            sys.exit('the recorded conversation replays to another state')
        print(len(asked), 'lines answered and replayed to', replayed['state'])
    return 0


if __name__ == '__main__':
    sys.exit(main())
