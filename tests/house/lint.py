#!/usr/bin/env python3
"""Rules that no compiler checks: includes name their module, and core keeps the promises of determinism.

usage: lint.py FOLDER. Prints one line a fault, exit status 1 if there is any."""
import os
import re
import sys

CODE = ('.cpp', '.h')
MODULES = ('core', 'firmware_io', 'replay', 'ui', 'tests')
MOST_SOURCES = 25

# What gives other bits, or another order, on another machine, compiler or day (never in core). symbols.py looks for the same
# in what was compiled, where no spelling hides it.
LIBM = ('sin|cos|tan|asin|acos|atan|atan2|sincos|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|'
        'hypot|cbrt|fma|tgamma|lgamma|erf|erfc|[jy][01n]')
SPECIAL = r'beta|arg|polar|riemann_zeta|expint|(?:cyl|sph)_\w+|(?:comp_)?ellint_[123]|(?:assoc_)?(?:legendre|laguerre)|hermite'
SORTS = 'sort|partial_sort|partial_sort_copy|nth_element|partition|make_heap|push_heap|pop_heap|sort_heap'
NOT_OURS = r'(?<![\w.>])(?<!base::)(?<!std::)(?:::)?(?<!\w::)'
BITS = 'the platform\'s libm gives other bits elsewhere; use core/base/math.h'
ORDER = 'what is equal keeps no order; use std::stable_sort or std::stable_partition'
CLOCK = 'core reads no clock and no random device'
LOCALE = 'its result depends on the locale; use core/base/numbers.h'
FLOATS = 'doubles are rounded as IEEE 754 says and nothing else; the flags of the build say how'
THREADS = 'core starts no thread'
HASHES = 'the order of addresses and hashes is another every time'
OUTSIDE = 'core reads no file, stream or environment'
IN_CORE = [(re.compile(rule), why) for rule, why in [
    (r'\bstd\s*::\s*(?:%s|%s)[fl]?\b' % (LIBM, SPECIAL), BITS),
    (NOT_OURS + r'(?:%s)\s*\(' % LIBM, BITS),
    (r'(?<![\w:.>])(?:%s)[fl]\s*\(' % LIBM, BITS),
    (r'(?<!&)&\s*(?:std\s*::\s*|::)?(?:%s)[fl]?\s*[;,)]' % LIBM, BITS),
    (r'__builtin_(?:%s|powi|nan\w*|inf\w*)[fl]?\b|#include <(?:complex|valarray|math\.h|tgmath\.h)>' % LIBM, BITS),
    (r'\bglm::(?:%s|rotate|slerp|angleAxis|angle|axis|eulerAngles|perspective|lookAt|radians|mix|normalize|length|distance|inversesqrt)\s*\(' % LIBM,
     'GLM\'s functions may change with its version and flags; use core/geometry'),
    (r'\bnamespace\s+\w+\s*=\s*std\b|\busing\s+namespace\s+std\s*;|\busing\s+std\s*::\s*(?:ranges\s*::\s*)?(?:%s|%s)\b' % (LIBM, SORTS),
     'what stands for std is written out, so that it is seen'),
    (r'\bstd\s*::\s*unordered_|#include <unordered_|\b(?:hash|flat_hash|node_hash)_(?:map|set)\b|\b__gnu_cxx\b|#include <ext/', 'hash containers have no fixed order'),
    (r'\bstd::(?:map|set|multimap|multiset|less)<\s*(?:const\s+)?[\w:]+\s*(?:const\s*)?\*|\bstd::(?:map|set|multimap|multiset)<\s*std::(?:shared|unique|weak)_ptr|\bu?intptr_t\b|\bstd::hash\b|boost/unordered', HASHES),
    (r'\bstd\s*::\s*(?:ranges\s*::\s*)?(?:%s)\s*\(|' % SORTS + NOT_OURS + r'(?:%s)\s*\(|\bq?sort_r?\s*\(|\bqsort\b|\bstd::priority_queue<(?!std::(?:size_t|u?int\d+_t)\b|int\b)' % SORTS, ORDER),
    (r'\b(?:clock_gettime|gettimeofday|clock|timespec_get|ftime|gmtime|localtime|strftime|mktime|nanosleep|usleep|time)\s*\(|\bstd::chrono\b|#include <(?:chrono|ctime|(?:sys/)?time\.h)>|\b__(?:TIME|DATE|TIMESTAMP)__\b|\b_?_?rdtscp?\b', CLOCK),
    (r'\b(?:s?rand(?:om)?|rand_r|[delmn]rand48|getrandom|getentropy|arc4random\w*)\s*\(|\b(?:random_device|mt19937(?:_64)?|minstd_rand0?|default_random_engine|\w+_distribution)\b|#include <random>|\bstd::(?:ranges::)?(?:shuffle|sample)\b', CLOCK),
    (r'\bstd::(?:locale|regex|wregex|format|vformat|use_facet)\b|\b(?:setlocale|localeconv|newlocale|uselocale|strcoll|strxfrm)\s*\(|#include <(?:locale|clocale|locale\.h|regex|format)>', LOCALE),
    (r'\b(?:strto(?:d|f|ld|u?ll?|imax)|ato(?:f|i|ll?)|sto(?:i|u?ll?|f|d|ld)|is(?:alnum|alpha|digit|space|upper|lower|punct|print|xdigit|cntrl|graph|blank)|to(?:lower|upper))\s*\(|\bstd::is(?:alpha|space|digit|alnum)\b|\bstd::to(?:lower|upper)\b|\b\w*(?:printf|scanf)\s*\(', LOCALE),
    (r'\b(?:secure_)?getenv\s*\(|#include <(?:fstream|filesystem|iostream|ostream|istream|sstream|iomanip|cstdio|stdio\.h|fcntl\.h|unistd\.h)>|\bstd::(?:cout|cerr|clog|cin|w?[io]?(?:string|f)stream|filesystem)\b|\b(?:fopen|fread|fwrite|mmap)\s*\(|(?<!\w)::open\s*\(', OUTSIDE),
    (r'\blong\s+double\b|\b(?:double|float)_t\b|\b__float128\b|\b_Float\d+|\b__fp16\b|\boptimize\s*\(|#include <(?:cfenv|fenv\.h|\w*mmintrin\.h|immintrin\.h|arm_neon\.h|x86intrin\.h)>|\bfe(?:set|hold)\w+\s*\(|\b_mm\d*_\w+|\b_MM_SET|\basm\b|\b__asm', FLOATS),
    (r'#\s*pragma\s+(?!once\b)[^\n]*|\b_Pragma\b', FLOATS),
    (r'\bstd::(?:reduce|transform_reduce|inclusive_scan|exclusive_scan|execution)\b|#include <execution>', 'reductions run in a fixed order'),
    (r'\bstd::(?:j?thread|async|mutex|shared_mutex|atomic\w*|future|promise|condition_variable)\b|\bthread_local\b|#include <(?:thread|mutex|atomic|future|condition_variable|pthread\.h)>', THREADS),
]]
# Never among the flags of any build.
IN_BUILD = re.compile(r'-ffast-math|-Ofast|-funsafe-math\S*|-fassociative-math|-freciprocal-math|-ffp-contract=(?!off)\w+|-m(?:arch|cpu|tune)=native|-mfma\b|-mfpmath\S*')
EVERYWHERE = [
    (re.compile(r'#include "(?!(?:%s)/)' % '|'.join(MODULES)), 'name the module in the include: "folder/module/header.h"'),
    (re.compile(r'#include "[^"]*\.\./'), 'no include climbs out of its folder'),
    (re.compile(r'\b(?:TODO|FIXME|XXX)\b'), 'finish it or leave it out'),
]
# A header below a folder `internal` is its module's own, and that of the module's tests.
INTERNAL = re.compile(r'#include "((?:\w+/)+)internal/\w+\.h"')
# What a call gives is looked at before it is used: .value() of an error ends the program. Where the line before says why it
# "Cannot fail", it may stay.
UNCHECKED = re.compile(r'\)\s*\.value\(\)|(?<![\w)\]])\*\s*(?:\w+::)+(?:make|read|open|load|parse|create)\w*\(')
MOVED = re.compile(r'std::move\([^()]*\)$')
# base/math.cpp makes the functions.
# libjpeg's header needs FILE.
EXEMPT = {'core/base/math.cpp', 'core/base/math.h', 'core/base/sine_cosine.cpp', 'core/picture/jpeg.cpp'}


CUT = re.compile(r'//[^\n]*|/\*.*?\*/|(?<![\w)])R"([^(\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'', re.S)


def code_alone(text):
    """The text without comments and what stands in quotes, line by line where it was; includes keep what they name."""
    def shortened(match):
        piece = match.group(0)
        if piece[0] == '"' and text[text.rfind('\n', 0, match.start()) + 1:match.start()].strip() == '#include':
            return piece
        return ('""' if piece[0] in '"\'R' else ' ') + '\n' * piece.count('\n')
    return CUT.sub(shortened, text)


def unchecked(text):
    """Lines, counted from 1, that take the value of a call without a look at it, and how they do."""
    code, lines = code_alone(text), text.split('\n')
    for match in UNCHECKED.finditer(code):
        line = code.count('\n', 0, match.start())
        said = line > 0 and 'Cannot fail' in lines[line - 1]
        if not said and not MOVED.search(code[:match.start() + 1]):
            yield line + 1, match.group(0).strip()


def taken_from_others(path, text):
    """Lines, counted from 1, that include what is internal to another module, and how they do."""
    mine = path[len('tests/'):] if path.startswith('tests/') else path
    for match in INTERNAL.finditer(text):
        if mine.split('/')[:2] != match.group(1).split('/')[:2]:
            yield text.count('\n', 0, match.start()) + 1, match.group(0)


def numbers_of_editions(root):
    """The number of today's edition stands in the code alone."""
    docs = os.path.join(root, 'docs')
    for name in sorted(os.listdir(docs)) if os.path.isdir(docs) else []:
        if not name.endswith('.md'):
            continue
        with open(os.path.join(docs, name), encoding='utf-8') as f:
            text = f.read()
        for match in re.finditer(r'\bedition=\d+|\bedition\.h`?; today \d+', text):
            yield 'docs/%s:%d: %s: a page grows old; core/base/edition.h has the number' % (name, text.count('\n', 0, match.start()) + 1, match.group(0))


def faults(root):
    for module in MODULES:
        for folder, folders, files in os.walk(os.path.join(root, module)):
            folders.sort()
            sources = sum(name.endswith(CODE) for name in files)
            if sources > MOST_SOURCES:
                yield '%s:0: %d sources: a room holds at most %d; make another' % (os.path.relpath(folder, root), sources, MOST_SOURCES)
            for name in sorted(files):
                if not name.endswith(CODE):
                    continue
                path = os.path.relpath(os.path.join(folder, name), root)
                with open(os.path.join(folder, name), encoding='utf-8') as f:
                    text = f.read()
                for line, what in taken_from_others(path, text):
                    yield '%s:%d: %s: what is internal to a module stays there' % (path, line, what)
                rules = [(r, why, text) for r, why in EVERYWHERE]
                if path.startswith('core/') and path not in EXEMPT:
                    code = code_alone(text)
                    rules += [(r, why, code) for r, why in IN_CORE]
                if not path.startswith('tests/'):
                    for line, what in unchecked(text):
                        yield '%s:%d: %s: look whether there is a value before it is taken' % (path, line, what)
                for rule, why, source in rules:
                    for match in rule.finditer(source):
                        yield '%s:%d: %s: %s' % (path, source.count('\n', 0, match.start()) + 1, match.group(0).strip(), why)
    yield from faults_of_the_build(root)
    yield from numbers_of_editions(root)


def faults_of_the_build(root):
    paths = [os.path.join(folder, name) for folder, _, names in os.walk(root) for name in names
             if (name == 'CMakeLists.txt' or name == 'CMakePresets.json' or name.endswith('.cmake'))
             and not os.path.relpath(folder, root).startswith('build')]
    for path in sorted(paths):
        with open(path, encoding='utf-8') as f:
            text = f.read()
        for match in IN_BUILD.finditer(text):
            yield '%s:%d: %s: %s' % (os.path.relpath(path, root), text.count('\n', 0, match.start()) + 1, match.group(0), FLOATS)


def main():
    found = list(faults(sys.argv[1]))
    for line in found:
        print(line)
    print('%d faults' % len(found))
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
