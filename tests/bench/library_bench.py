#!/usr/bin/env python3
"""What a call through Python costs beyond the same call in C (library_bench, started here), on the same character: solving from rest,
evaluating, and "empty", a solve that has nothing to do, where the difference shows best. usage: library_bench.py LIBRARY_BENCH, with
PENPOSE_LIBRARY and PYTHONPATH naming the library and the package."""
import re
import statistics
import subprocess
import sys
import time

import penpose

ROUNDS = 1000


def median_us(call):
    times = []
    for _ in range(ROUNDS):
        before = time.perf_counter_ns()
        call()
        times.append((time.perf_counter_ns() - before) / 1000)
    return statistics.median(times)


def main():
    head = penpose.Character.built_in('builtin:demo')
    lip = head.curve('lip_upper')
    head.target(lip, head.positions(lip) + [0, 0.002, 0])
    out = head.evaluate()

    def solve(preset):
        def call():
            head.reset()
            head.solve(preset)
        return call

    empty = head.copy()
    empty.clear()
    calls = {'empty': empty.solve, 'solve': solve(penpose.Preset.DEFAULT), 'exact': solve(penpose.Preset.EXACT), 'evaluate': lambda: head.evaluate(out=out)}
    said = subprocess.run([sys.argv[1], str(ROUNDS)], check=True, stdout=subprocess.PIPE, text=True).stdout
    in_c = {name: float(us) for name, us in re.findall(r'^(\w+) .*, C +([0-9.]+) us', said, re.M)}
    print(said, end='')
    for name, call in calls.items():
        # What is best of three stands for a machine that others use too.
        us = min(median_us(call) for _ in range(3))
        calls_made = 2 if name in ('solve', 'exact') else 1
        print('%-10s Python %9.2f us, C %9.2f us, ratio %.4f, Python takes %+.2f us more, in %d calls' % (
            name, us, in_c[name], us / in_c[name], us - in_c[name], calls_made))


if __name__ == '__main__':
    main()
