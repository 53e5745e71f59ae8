"""Libraries to link against in the place of the system's glibc, so that what is linked runs with an older one: stubs.py COMPILER VERSION FOLDER

A stub has the names of the system's libc.so.6, libm.so.6 and loader, each with the newest version that is not above VERSION, and no code.
What came later is not in it: to need it is an error of the linker, not of who runs the library. Names that glibc moved into libc.so.6 later
(https://sourceware.org/glibc/wiki/Release/2.34) lie in the library that they came from.
"""
import os
import re
import subprocess
import sys

# Libraries that are a part of libc.so.6 since 2.34, by the names that moved; all others were libpthread's.
MOVED = [('libdl.so.2', r'_*dl'), ('librt.so.1', r'(aio|lio|mq|shm|timer)_'), ('libresolv.so.2', r'_*(res|ns|dn|inet|b64|hostalias|p_|sym_)'),
         ('libutil.so.1', r'(forkpty|openpty|login|logout|logwtmp)'), ('libanl.so.1', r'(gai_|getaddrinfo_a)'), ('libpthread.so.0', '')]


def path_of(compiler, name):
    """Where the compiler finds a library."""
    path = subprocess.run([compiler, '-print-file-name=' + name], check=True, capture_output=True, text=True).stdout.strip()
    if not os.path.isabs(path):
        sys.exit('stubs.py: %s does not know where %s lies' % (compiler, name))
    return os.path.realpath(path)


def number(version):
    """2.2.5 as (2, 2, 5)."""
    return tuple(map(int, version.split('.')))


def names_of(path):
    """The names that a library defines: {name: {version: kind of symbol}}."""
    out = subprocess.run(['nm', '-D', '--defined-only', '--with-symbol-versions', path], check=True, capture_output=True, text=True).stdout
    names = {}
    for kind, name, version in re.findall(r' ([A-Za-z]) (\w+)@@?GLIBC_([0-9.]+)$', out, re.M):
        names.setdefault(name, {})[number(version)] = kind
    return names


def stubs_of(name, path, newest):
    """What is in a stub and in those of libraries that became a part of it: {library: [(name, version, kind)]}."""
    out = {name: []}
    for symbol, versions in sorted(names_of(path).items()):
        old = [v for v in versions if v <= newest]
        if not old:
            continue
        library = name
        if name == 'libc.so.6' and max(versions) > newest:
            library = next(one for one, names in MOVED if re.match(names, symbol))
        out.setdefault(library, []).append((symbol, max(old), versions[max(old)]))
    return out


def make(compiler, folder, library, symbols):
    """Links a stub."""
    source, script = os.path.join(folder, library + '.s'), os.path.join(folder, library + '.map')
    with open(source, 'w', encoding='utf-8') as f:
        for name, _, kind in symbols:
            data = kind in 'BbDdRrVvGgSs'
            f.write('%s\n.globl %s\n.type %s, %%%s\n%s: .long 0\n.size %s, 4\n' % (
                '.data' if data else '.text', name, name, 'object' if data else 'function', name, name))
        f.write('.section .note.GNU-stack,"",%progbits\n')
    with open(script, 'w', encoding='utf-8') as f:
        for version in sorted({v for _, v, _ in symbols}):
            f.write('GLIBC_%s { global: %s };\n' % ('.'.join(map(str, version)), ' '.join(n + ';' for n, v, _ in symbols if v == version)))
    subprocess.run([compiler, '-shared', '-nostdlib', '-Wl,-soname,' + library, '-Wl,--version-script,' + script, '-o',
                    os.path.join(folder, library), source], check=True)


def main():
    compiler, newest, folder = sys.argv[1], number(sys.argv[2]), sys.argv[3]
    os.makedirs(folder, exist_ok=True)
    libc = path_of(compiler, 'libc.so.6')
    needed = subprocess.run(['readelf', '-d', libc], check=True, capture_output=True, text=True).stdout
    loader = re.search(r'NEEDED.*\[(ld[^]]*)\]', needed).group(1)
    stubs = {**stubs_of('libc.so.6', libc, newest), **stubs_of('libm.so.6', path_of(compiler, 'libm.so.6'), newest),
             **stubs_of(loader, path_of(compiler, loader), newest)}
    for library, symbols in stubs.items():
        make(compiler, folder, library, symbols)
    parts = ' '.join(one for one in stubs if one != 'libm.so.6')
    for name, text in (('libc.so', parts), ('libm.so', 'libm.so.6'), ('libpthread.so', parts), ('libdl.so', parts), ('librt.so', parts)):
        with open(os.path.join(folder, name), 'w', encoding='utf-8') as f:
            f.write('GROUP ( AS_NEEDED ( %s ) )\n' % text)


if __name__ == '__main__':
    main()
