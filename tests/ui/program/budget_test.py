#!/usr/bin/env python3
"""No file takes more than it may: the worst of each kind is read, or refused with one line, in under 40 times its size plus 50 MB.
Times are told and not judged, as machines differ; what takes a minute of a processor counts as endless and is ended.

usage: budget_test.py PENPOSE"""
import os
import resource
import sys
import tempfile
import time

import worst_files

PENPOSE = os.path.abspath(sys.argv[1])
USUAL_S = 5.0
ENDLESS_S = 60
MOST_TIMES = 40
MOST_BYTES = 50e6
# Pictures are drawn by a driver that takes a few hundred megabytes for itself and for the samples of every pixel.
DRAWS = {'huge_view': 450e6, 'no_textures': 450e6, 'texture_bomb': 450e6}
ONE_NOTE = 'textures cannot be drawn and are grey: '


def measure(arguments, errors):
    """Exit status or -signal, processor seconds, most bytes at once."""
    child = os.fork()
    if child == 0:
        null, log = os.open('/dev/null', os.O_RDWR), os.open(errors, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        for to, number in ((null, 0), (null, 1), (log, 2)):
            os.dup2(to, number)
        resource.setrlimit(resource.RLIMIT_CPU, (ENDLESS_S, ENDLESS_S))
        os.execv(PENPOSE, [PENPOSE] + arguments)
    _, status, usage = os.wait4(child, 0)
    return os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def main():
    failed = 0
    for make in worst_files.ALL:
        with tempfile.TemporaryDirectory() as folder:
            arguments, files = make(folder)
            size = sum(os.path.getsize(path) for path in files)
            errors = os.path.join(folder, 'errors')
            status, seconds, memory = measure(arguments, errors)
            with open(errors, encoding='utf-8') as f:
                said = f.read()
            budget = MOST_TIMES * size + MOST_BYTES + DRAWS.get(make.__name__, 0)
            good = status in (0, 1) and memory < budget
            good = good and (status == 0 or (said.count('\n') == 1 and said.startswith('penpose: ')))
            if make.__name__ == 'no_textures':
                good = good and status == 0 and said.count('\n') == 1 and '10 ' + ONE_NOTE in said
            failed += not good
            print('%s %-22s %8.0f kB: status %d, %5.2f s, %5.0f of %5.0f MB  %s' %
                  ('FAIL' if not good else 'ok  ' if seconds < USUAL_S else 'slow', make.__name__, size / 1e3, status, seconds, memory / 1e6, budget / 1e6, said[:150].strip()))
    return 1 if failed else 0


if __name__ == '__main__':
    started = time.time()
    result = main()
    print('%.1f s in all' % (time.time() - started))
    sys.exit(result)
