#!/usr/bin/env python3
"""Rules that no compiler checks: includes name their module, and core keeps the promises of determinism.

usage: lint.py FOLDER. Prints one line a fault, exit status 1 if there is any."""
import os
import re
import sys

CODE = ('.cpp', '.h')
MODULES = ('core', 'firmware_io', 'replay', 'ui', 'tests')

# What gives other bits, or another order, on another machine, compiler or day (never in core).
LIBM = 'sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|hypot|cbrt|fma|tgamma|lgamma|erf|erfc'
IN_CORE = [
    (re.compile(r'\bstd::(?:%s)f?l?\s*\(' % LIBM), 'the platform\'s libm gives other bits elsewhere; use core/base/math.h'),
    (re.compile(r'(?<![\w.>])(?<!base::)(?<!std::)(?:::)?(?<!\w::)(?:%s)\s*\(' % LIBM), 'the platform\'s libm gives other bits elsewhere; use core/base/math.h'),
    (re.compile(r'\bstd::(?:%s|arg|polar|beta)\b|__builtin_(?:%s)f?\b' % (LIBM, LIBM)), 'the platform\'s libm gives other bits elsewhere; use core/base/math.h'),
    (re.compile(r'\b(?:clock_gettime|gettimeofday|clock|rand|srand|random|drand48)\s*\(|#include <(?:sys/)?time\.h>'), 'core reads no clock and no random device'),
    (re.compile(r'\bstd::(?:tolower|toupper|isalpha|isspace|isdigit|o?i?stringstream|ostringstream|istringstream|stof|stold|sto[iu]?l+|stoi)\b|\b(?:sn|s|vsn)?printf\s*\(|\bs?scanf\s*\('), 'its result depends on the locale; use core/base/numbers.h'),
    (re.compile(r'\bstd::(?:map|set|multimap|multiset)<\s*(?:const\s+)?[\w:]+\s*(?:const\s*)?\*|\bstd::hash\b|boost/unordered'), 'the order of addresses and hashes is another every time'),
    (re.compile(r'(?<![\w:.>])(?:%s)f\s*\(' % LIBM), 'the platform\'s libm gives other bits elsewhere; use core/base/math.h'),
    (re.compile(r'\bglm::(?:%s|rotate|slerp|angleAxis|angle|axis|eulerAngles|perspective|lookAt|radians|mix|normalize|length|distance|inversesqrt)\s*\(' % LIBM),
     'GLM\'s functions may change with its version and flags; use core/geometry'),
    (re.compile(r'\bstd::unordered_|#include <unordered_'), 'hash containers have no fixed order'),
    (re.compile(r'#include <(?:chrono|ctime|random|locale|fstream|filesystem|iostream|cstdio)>'), 'core reads no clock, file, locale or random device'),
    (re.compile(r'\b(?:getenv|setlocale|strtod|atof|stod|time)\s*\('), 'core reads no environment, clock or locale'),
    (re.compile(r'\bstd::(?:ranges::)?(?:sort|partial_sort|nth_element|partition|make_heap|push_heap|pop_heap|sort_heap)\s*\('),
     'what is equal keeps no order; use std::stable_sort or std::stable_partition'),
    (re.compile(r'\bstd::(?:reduce|transform_reduce|execution)\b'), 'reductions run in a fixed order'),
]
EVERYWHERE = [
    (re.compile(r'#include "(?!(?:%s)/)' % '|'.join(MODULES)), 'name the module in the include: "folder/module/header.h"'),
    (re.compile(r'#include "[^"]*\.\./'), 'no include climbs out of its folder'),
    (re.compile(r'\b(?:TODO|FIXME|XXX)\b'), 'finish it or leave it out'),
]
# base/math.cpp makes the functions; threads live in base/parallel.
EXEMPT = {'core/base/parallel.cpp', 'core/base/math.cpp', 'core/base/math.h', 'core/base/sine_cosine.cpp'}


def strip_comments(text):
    return re.sub(r'//[^\n]*|/\*.*?\*/', lambda m: '\n' * m.group(0).count('\n'), text, flags=re.S)


def faults(root):
    for module in MODULES:
        for folder, folders, files in os.walk(os.path.join(root, module)):
            folders.sort()
            for name in sorted(files):
                if not name.endswith(CODE):
                    continue
                path = os.path.relpath(os.path.join(folder, name), root)
                with open(os.path.join(folder, name), encoding='utf-8') as f:
                    text = f.read()
                rules = [(r, why, text) for r, why in EVERYWHERE]
                if path.startswith('core/') and path not in EXEMPT:
                    code = strip_comments(text)
                    rules += [(r, why, code) for r, why in IN_CORE]
                for rule, why, source in rules:
                    for match in rule.finditer(source):
                        yield '%s:%d: %s: %s' % (path, source.count('\n', 0, match.start()) + 1, match.group(0).strip(), why)


def main():
    found = list(faults(sys.argv[1]))
    for line in found:
        print(line)
    print('%d faults' % len(found))
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
