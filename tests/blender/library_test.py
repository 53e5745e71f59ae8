"""The C libraries of the add-on's zip, without Blender: what they need of the system, and golden sessions through them.

library_test.py ZIP PLAYER WINDOWS_PLAYER HASHES SESSION... The one for Windows is tried in Wine, where both are."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

ZIP, PLAYER, WINDOWS_PLAYER, HASHES, *SESSIONS = sys.argv[1:]
GLIBC = (2, 28)
# Parts of glibc, by the names that they had then; the loader's name is the machine's.
PARTS = r'^(lib(c|m)\.so\.6|libpthread\.so\.0|libdl\.so\.2|ld-linux[-a-z0-9]*\.so\.\d)$'
# What every Windows has.
WINDOWS = {'KERNEL32.dll', 'ADVAPI32.dll', 'msvcrt.dll', 'USER32.dll'}
WINE = shutil.which('wine64', path=os.environ['PATH'] + ':/usr/lib/wine')


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def number(version):
    return tuple(map(int, version.split('.')))


class Libraries(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.libraries = {}
        with zipfile.ZipFile(ZIP) as packed:
            for name in packed.namelist():
                found = re.match(r'penpose_blender/library/(\w+-\w+)-[^/]+/.', name)
                if found:
                    cls.libraries[found.group(1)] = packed.extract(name, cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def linux(self):
        found = [path for system, path in self.libraries.items() if system.startswith('linux')]
        self.assertEqual(len(found), 1)
        return found[0]

    def windows(self):
        if 'windows-x64' not in self.libraries:
            self.skipTest('the zip has no library for Windows (PENPOSE_ADDON_WINDOWS)')
        return self.libraries['windows-x64']

    def test_linux_needs_glibc_alone(self):
        needed = re.findall(r'\(NEEDED\).*\[(.*)\]', said('readelf', '-dW', self.linux()))
        self.assertTrue(needed)
        for name in needed:
            self.assertRegex(name, PARTS)

    def test_linux_needs_no_new_version(self):
        named = re.findall(r'Name: ([A-Z]+)_([0-9.]+)', said('readelf', '-VW', self.linux()).partition("needs section")[2])
        self.assertGreater(len(named), 3)
        for kind, version in named:
            self.assertEqual(kind, 'GLIBC', version)
            self.assertLessEqual(number(version), GLIBC)

    def test_linux_finds_each_version_where_it_was(self):
        # Threads were a library of their own; a library that does not name it finds them only if somebody else does.
        names = said('readelf', '--dyn-syms', '-W', self.linux())
        self.assertRegex(names, r'UND pthread_\w+@GLIBC_2')
        self.assertIn('libpthread.so.0', said('readelf', '-dW', self.linux()))

    def test_linux_can_be_unloaded(self):
        names = said('readelf', '--dyn-syms', '-W', self.linux())
        self.assertNotIn('UNIQUE', names, 'glibc keeps a library with such a name for good')
        self.assertNotIn('NODELETE', said('readelf', '-dW', self.linux()))

    def test_linux_exports_its_interface_alone(self):
        defined = [line.split()[7] for line in said('readelf', '--dyn-syms', '-W', self.linux()).splitlines()[4:] if ' UND ' not in line]
        self.assertGreater(len(defined), 40)
        self.assertEqual([name for name in defined if not name.lower().startswith('penpose_')], [])

    def test_linux_golden(self):
        self.assertGreater(len(SESSIONS), 5)
        self.assertEqual(said(PLAYER, self.linux(), HASHES, *SESSIONS), '%d sessions, 0 wrong\n' % len(SESSIONS))

    def test_windows_needs_windows_alone(self):
        text = said('x86_64-w64-mingw32-objdump', '-p', self.windows())
        self.assertLessEqual(set(re.findall(r'DLL Name: (\S+)', text)), WINDOWS)

    def test_windows_golden(self):
        library = self.windows()
        if WINE is None:
            self.skipTest('Wine is not installed (package wine64)')
        with tempfile.TemporaryDirectory() as home:
            environment = {**os.environ, 'HOME': home, 'WINEPREFIX': os.path.join(home, 'wine'), 'WINEDEBUG': '-all'}
            environment.pop('DISPLAY', None)
            run = subprocess.run([WINE, WINDOWS_PLAYER, library, HASHES, *SESSIONS], capture_output=True, text=True, env=environment, check=False)
            subprocess.run([os.path.join(os.path.dirname(WINE), 'wineserver'), '-k'], env=environment, check=False, capture_output=True)
        self.assertEqual((run.stdout.strip(), run.returncode), ('%d sessions, 0 wrong' % len(SESSIONS), 0), run.stderr)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
