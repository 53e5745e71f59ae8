#!/usr/bin/env python3
"""What core calls in other libraries, read from its compiled modules: lint.py reads the sources, but an alias, a template or an
inlined header may hide a call there.

usage: symbols.py NM LIBRARY.a... Prints one line a fault, exit status 1 if there is any."""
import os
import re
import subprocess
import sys

LIBM = ('sin|cos|tan|asin|acos|atan|atan2|sincos|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|hypot|'
        'cbrt|fma|tgamma|lgamma|lgamma_r|erf|erfc|j0|j1|jn|y0|y1|yn')
REFUSED = [(re.compile(rule), why) for rule, why in [
    (r'^(?:__)?(?:%s)[fl]?(?:_finite)?$' % LIBM, 'the platform\'s libm gives other bits elsewhere'),
    (r'^(?:qsort|qsort_r)$', 'what is equal keeps no order'),
    (r'_Prime_rehash_policy|^std::_Hash_bytes|^std::_Fnv_hash', 'hash containers have no fixed order'),
    (r'^(?:clock|clock_gettime|gettimeofday|time|timespec_get|ftime|mktime|localtime\w*|gmtime\w*|strftime|nanosleep|usleep)$|^std::chrono', 'core reads no clock'),
    (r'^(?:s?rand(?:om)?(?:_r)?|[delmn]rand48(?:_r)?|getrandom|getentropy|arc4random\w*)$|^std::random_device', 'core reads no random device'),
    (r'^(?:setlocale|localeconv|newlocale|uselocale|strto(?:d|f|ld)(?:_l)?|atof|\w*printf(?:_chk)?|\w*scanf|strcoll|strxfrm|is(?:alnum|alpha|digit|space|upper|lower|punct)|to(?:lower|upper)|__ctype_\w+)$|^std::(?:__cxx11::)?(?:locale|basic_[io]?stringstream|basic_regex)', 'its result depends on the locale'),
    (r'^(?:fopen|fopen64|fdopen|open|open64|openat|read|write|fread|fwrite|mmap)$|^std::(?:basic_[io]?fstream|basic_filebuf|filesystem|cout|cerr|cin|clog)', 'core reads no file and no stream'),
    (r'^(?:secure_)?getenv$', 'core reads no environment'),
    (r'^fe(?:set|hold|update)\w+$', 'doubles are rounded as IEEE 754 says'),
    (r'^(?:pthread_create|GOMP_\w+|omp_\w+|sched_\w+)$|^std::thread', 'core starts no thread'),
]]
# What libraries bring along that are compiled into a module, by the object that has it.
EXEMPT = {
    'subdivision.cpp.o': r'^cos$|^std::(?:basic|c)|stringstream',  # OpenMesh's test for feature edges and its streams, never called
    # tinygltf's ways to files, which it is given none of (SetFsCallbacks), and how it writes numbers into errors and names of files.
    'own_tinygltf.cpp.o': r'^fopen$|^isalnum$|^std::basic_(?:filebuf|[io]fstream)<|^std::locale::|^std::__cxx11::basic_stringstream<',
}


def undefined(nm, library):
    object_name = ''
    for line in subprocess.run([nm, '-uC', library], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.splitlines():
        if line.endswith('.o:'):
            object_name = line[:-1]
        elif line.strip():
            yield object_name, line.split(None, 1)[1].split('@')[0] if line.split(None, 1)[0] in 'Uwv' else line.strip()


def faults(nm, library):
    for object_name, symbol in undefined(nm, library):
        allowed = EXEMPT.get(object_name)
        if allowed and re.search(allowed, symbol):
            continue
        for rule, why in REFUSED:
            if rule.search(symbol):
                yield '%s(%s): %s: %s' % (os.path.basename(library), object_name, symbol, why)


def main():
    found = [line for library in sys.argv[2:] for line in faults(sys.argv[1], library)]
    for line in found:
        print(line)
    print('%d faults in %d modules' % (len(found), len(sys.argv) - 2))
    return 1 if found or len(sys.argv) < 3 else 0


if __name__ == '__main__':
    sys.exit(main())
