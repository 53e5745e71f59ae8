#!/usr/bin/env python3
"""Calls that no reading of the source finds are found in what was compiled.

usage: symbols_test.py NM COMPILER"""
import os
import subprocess
import sys
import tempfile

import symbols

BAD = {
    'template': '#include <cmath>\ntemplate <double (*F)(double)> double call(double x) { return F(x); }\n'
                'double f(double x) { return call<std::cosh>(x); }\n',
    'macro': '#include <cmath>\n#define PASTED(a, b) a##b\ndouble f(double x) { return PASTED(lo, g)(x); }\n',
    'text': '#include <string>\nstd::string f(double x) { return std::to_string(x); }\n',
    'alias': '#include <chrono>\nnamespace c = std::chrono;\nlong f() { return c::steady_clock::now().time_since_epoch().count(); }\n',
    'hash': '#include <unordered_map>\nint f(int x) { std::unordered_map<int, int> m; m[x] = 1; return m.begin()->first; }\n',
    'order': '#include <cstdlib>\nvoid f(int* a, int (*c)(const void*, const void*)) { std::qsort(a, 9, 4, c); }\n',
    'random': '#include <random>\nunsigned f() { std::random_device d; return d(); }\n',
    'file': '#include <fstream>\nvoid f() { std::ofstream("a") << 1; }\n',
}
GOOD = '#include <algorithm>\n#include <cmath>\n#include <vector>\n' \
       'double f(std::vector<double> v) { std::stable_sort(v.begin(), v.end()); return std::sqrt(v[0]) + std::floor(v[1]); }\n'


def found(text):
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, 'a.cpp')
        with open(source, 'w', encoding='utf-8') as f:
            f.write(text)
        made = os.path.join(folder, 'a.o')
        subprocess.run([sys.argv[2], '-std=c++20', '-O2', '-c', source, '-o', made], check=True)
        return list(symbols.faults(sys.argv[1], made))


for name, text in BAD.items():
    assert found(text), name
assert not found(GOOD), found(GOOD)
print('what is called is found')
