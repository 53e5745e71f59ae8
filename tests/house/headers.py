#!/usr/bin/env python3
"""Every public header compiles alone, with no more before it than its module may include.

The standard library and GLM are read once, in a precompiled header, as they take most of the time; so a header that uses
them names what it uses: the words of NAMES, each with the header that has it.

usage: headers.py CLANG MODULES_FOLDER WORK_FOLDER     MODULES_FOLDER holds a file a module: its include folders in one
line, divided by semicolons, and then a header a line."""
import concurrent.futures
import os
import re
import subprocess
import sys

clang, modules, work = sys.argv[1:]
os.makedirs(work, exist_ok=True)

COMMON = ['algorithm', 'array', 'bit', 'cmath', 'cstddef', 'cstdint', 'cstdio', 'cstdlib', 'cstring', 'filesystem', 'functional', 'iosfwd',
          'limits', 'map', 'memory', 'numeric', 'optional', 'set', 'span', 'string', 'string_view', 'tuple', 'utility', 'variant', 'vector',
          'glm/common.hpp', 'glm/geometric.hpp', 'glm/gtc/quaternion.hpp', 'glm/mat3x3.hpp', 'glm/mat4x4.hpp', 'glm/vec2.hpp',
          'glm/vec3.hpp', 'glm/vec4.hpp']
NAMES = {'array': r'std::array\b', 'vector': r'std::vector\b', 'string': r'std::(?:string\b(?!_view)|to_string\b)', 'string_view': r'std::string_view\b',
         'optional': r'std::(?:optional|nullopt)\b', 'variant': r'std::(?:variant|visit|get_if|holds_alternative)\b', 'span': r'std::span\b',
         'map': r'std::map\b', 'set': r'std::set\b', 'memory': r'std::(?:unique_ptr|shared_ptr|weak_ptr|make_unique|make_shared)\b',
         'functional': r'std::function\b', 'utility': r'std::(?:pair|move|exchange|swap)\b', 'limits': r'std::numeric_limits\b',
         'cstdint': r'std::u?int(?:8|16|32|64)_t\b', 'cmath': r'std::(?:sqrt|abs|floor|ceil|round|fma|isfinite)\b',
         'algorithm': r'std::(?:min|max|clamp|sort|find|find_if|fill|copy|any_of|all_of|none_of|lower_bound|upper_bound)\b',
         'filesystem': r'std::filesystem\b', 'bit': r'std::(?:bit_cast|popcount|countr_zero)\b', 'tuple': r'std::(?:tuple|tie)\b'}


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def included(path, folders, seen):
    """The standard headers that a header brings, its own and those of the project's headers that it includes."""
    if path in seen:
        return set()
    seen.add(path)
    text = read(path)
    found = set(re.findall(r'^#include <([^>]*)>', text, re.M))
    for name in re.findall(r'^#include "([^"]*)"', text, re.M):
        for folder in folders:
            if os.path.exists(os.path.join(folder, name)):
                found |= included(os.path.join(folder, name), folders, seen)
                break
    return found


def unnamed(path, folders):
    code = re.sub(r'//[^\n]*|"(?:[^"\\\n]|\\.)*"', '', read(path))
    brought = included(path, folders, set())
    return ['%s: uses %s and does not include <%s>' % (path, re.search(pattern, code).group(), header)
            for header, pattern in NAMES.items() if re.search(pattern, code) and header not in brought]


def compiled(path, folders, flags):
    run = subprocess.run([clang, *flags, '-include-pch', os.path.join(work, 'common.pch'), '-fsyntax-only', '-Wno-pragma-once-outside-header',
                          *['-I' + folder for folder in folders], '-x', 'c++', path], capture_output=True, text=True, check=False)
    return run.stderr if run.returncode else ''


def main():
    flags = ['-std=c++20']
    common = os.path.join(work, 'common.h')
    with open(common, 'w', encoding='utf-8') as file:
        file.writelines('#include <%s>\n' % name for name in COMMON)
    subprocess.run([clang, *flags, '-x', 'c++-header', common, '-o', os.path.join(work, 'common.pch')], check=True)
    jobs = []
    for name in sorted(os.listdir(modules)):
        folders, *headers = read(os.path.join(modules, name)).split('\n')
        folders = [folder for folder in folders.split(';') if folder]
        jobs += [(header, folders) for header in headers if header]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = [fault for header, folders in jobs for fault in unnamed(header, folders)]
        faults += [said for said in pool.map(lambda job: compiled(*job, flags), jobs) if said]
    print('\n'.join(faults))
    print('%d headers, %d faults' % (len(jobs), len(faults)))
    return 1 if faults or not jobs else 0


sys.exit(main())
