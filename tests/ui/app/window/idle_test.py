"""Nothing is drawn while nothing changes: the window under Xvfb is left alone, and then told to end.

    idle_test.py PROGRAM
"""

import os
import shutil
import subprocess
import sys
import tempfile
import time

from window_test import Screen

IDLE_S = 3
MOST_CPU_S = 0.05


def cpu_s(process):
    with open(f"/proc/{process.pid}/stat") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def leave_alone(program, screen, *options):
    process = subprocess.Popen([program, "--timings", *options], env=screen.environment, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True)
    # Until edges are smooth and what was said is gone.
    end = time.monotonic() + 60
    before = -1.0
    while time.monotonic() < end and cpu_s(process) != before:
        before = cpu_s(process)
        time.sleep(5)
    assert process.poll() is None, process.stdout.read()
    before = cpu_s(process)
    time.sleep(IDLE_S)
    used = cpu_s(process) - before
    process.terminate()
    said = process.communicate(timeout=20)[0]
    assert process.returncode == 0, said
    idle_us = int(next(line for line in said.splitlines() if line.startswith("idle_us")).split()[1])
    print(options, f"{used:.2f} s of the processor, the last frame {idle_us / 1e6:.1f} s ago")
    assert idle_us >= IDLE_S * 1e6, said
    assert used <= MOST_CPU_S, used


folder = tempfile.mkdtemp()
screen = Screen(folder, None, 800, 480)
try:
    leave_alone(sys.argv[1], screen, "--draw", "cpu")
    leave_alone(sys.argv[1], screen, "--draw", "cpu", "--screen-kind", "slow", "--rotate", "90")
finally:
    screen.close()
    shutil.rmtree(folder)
