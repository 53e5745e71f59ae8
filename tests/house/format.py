#!/usr/bin/env python3
"""Every source is formatted by .clang-format. usage: format.py CLANG_FORMAT FOLDER"""
import os
import subprocess
import sys

tool, root = sys.argv[1:]
files = [os.path.join(d, f) for m in ('core', 'firmware_io', 'replay', 'ui', 'tests')
         for d, _, names in os.walk(os.path.join(root, m)) if 'node_modules' not in d
         for f in sorted(names) if f.endswith(('.cpp', '.h'))]
status = 0
for begin in range(0, len(files), 40):
    status |= subprocess.run([tool, '--dry-run', '--Werror', '--ferror-limit=1'] + files[begin:begin + 40], cwd=root).returncode
sys.exit(1 if status else 0)
