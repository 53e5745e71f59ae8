#!/usr/bin/env python3
"""What libpenpose.so gives to others: the functions that penpose.h declares and penpose.map lists, and nothing else."""
import argparse
import re
import subprocess
import sys


def exported(nm, library):
    lines = subprocess.run([nm, '-D', '--defined-only', library], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    return {line.split()[-1].split('@')[0] for line in lines if line.split()[1] != 'A'}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ('nm', 'library', 'source'):
        parser.add_argument('--' + name, required=True)
    arguments = parser.parse_args()
    with open(arguments.source + '/ui/capi/penpose.h', encoding='utf-8') as file:
        header = re.sub(r'/\*.*?\*/', '', file.read(), flags=re.S)
    declared = set(re.findall(r'^PENPOSE_API [^;(]*?\b(penpose_\w+)\(', header, re.M))
    with open(arguments.source + '/ui/capi/penpose.map', encoding='utf-8') as file:
        listed = set(re.findall(r'\b(penpose_\w+);', file.read()))
    with open(arguments.source + '/ui/python/penpose/_c.py', encoding='utf-8') as file:
        called = set(re.findall(r'\b(penpose_\w+)\b', file.read())) - {'penpose_status'}
    found = exported(arguments.nm, vars(arguments)['library'])
    faults = ['%s is %s' % (name, what) for names, what in (
        (found - declared, 'exported and not declared'), (declared - found, 'declared and not exported'),
        (declared ^ listed, 'in one of penpose.h and penpose.map alone'), (called - declared, 'called in Python and not declared'))
        for name in sorted(names)]
    with open(arguments.source + '/ui/capi/penpose.h', encoding='utf-8') as file:
        abi = re.search(r'#define PENPOSE_ABI_VERSION (\d+)', file.read()).group(1)
    elf = subprocess.run(['readelf', '-d', vars(arguments)['library']], check=True, stdout=subprocess.PIPE, text=True).stdout
    if 'soname: [libpenpose.so.%s]' % abi not in elf:
        faults.append('the file name does not have the number of the interface, %s' % abi)
    print('\n'.join(faults + ['%d functions, %d faults' % (len(found), len(faults))]))
    return 1 if faults or not found else 0


if __name__ == '__main__':
    sys.exit(main())
