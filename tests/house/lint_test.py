#!/usr/bin/env python3
"""The lint finds what it is there to find, and nothing else."""
import os
import tempfile

import lint

BAD = {
    'core/rig/a.cpp': 'double f(double x) { return std::sin(x); }\n',
    'core/rig/b.cpp': '#include <unordered_map>\n',
    'core/rig/h.cpp': 'double f(double x) { using std::exp; return exp(x); }\n',
    'core/rig/i.cpp': 'auto a = std::transform(b, e, o, std::exp);\n',
    'core/rig/j.cpp': 'timespec t; clock_gettime(0, &t);\n',
    'core/rig/k.cpp': 'std::ostringstream out;\n',
    'core/rig/l.cpp': 'std::map<const Node*, int> seen;\n',
    'core/rig/m.cpp': 'double f(double x) { return ::pow(x, 2); }\n',
    'core/rig/s.cpp': 'void f(int* a) { std::sort(a, a + 2); }\n',
    'core/rig/c.cpp': '#include "../mesh/mesh.h"\n',
    'core/rig/d.cpp': '#include "mesh.h"\n',
    'core/rig/e.cpp': '#include <chrono>\n',
    'core/rig/f.cpp': 'auto n = glm::normalize(v);\n',
    'core/rig/g.cpp': 'float y = sinf(x);\n',
}
GOOD = {
    'core/rig/a.cpp': '#include "core/base/math.h"\n// std::sin( would differ\ndouble f(double x) { return base::sin(x) + std::sqrt(x); }\n',
    'ui/app/b.cpp': '#include <chrono>\n#include <unordered_map>\ndouble g(double x) { return std::sin(x); }\n',
    'core/base/math.cpp': 'double sin(double x) { return std::frexp(x, nullptr); }\n',
}


def count(files):
    with tempfile.TemporaryDirectory() as root:
        for path, text in files.items():
            os.makedirs(os.path.join(root, os.path.dirname(path)), exist_ok=True)
            with open(os.path.join(root, path), 'w', encoding='utf-8') as f:
                f.write(text)
        return {line.split(':')[0] for line in lint.faults(root)}


assert count(BAD) == set(BAD), count(BAD)
assert count(GOOD) == set(), count(GOOD)
print('the lint finds its faults')
