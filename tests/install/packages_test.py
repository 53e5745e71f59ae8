#!/usr/bin/env python3
"""packages_test.py BUILD FOLDER [EMULATOR...]: packs BUILD's components into FOLDER; lintian finds no error, packages ask for just what
their programs need, and the one without the window needs neither SDL nor OpenGL. EMULATOR... runs programs of another machine; what its
packages ask for is tried where they are installed (root_test.sh), as dpkg-shlibdeps knows the libraries of this machine alone."""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, FOLDER = [os.path.abspath(a) for a in sys.argv[1:3]]
EMULATOR = sys.argv[3:]
shutil.rmtree(FOLDER, ignore_errors=True)
os.makedirs(FOLDER)
subprocess.run(['cpack', '--config', os.path.join(BUILD, 'CPackConfig.cmake'), '-B', FOLDER], check=True, stdout=subprocess.DEVNULL, cwd=FOLDER)


def field(package, name):
    return subprocess.run(['dpkg-deb', '-f', package, name], check=True, capture_output=True, text=True).stdout.strip()


def names_in(depends):
    return {part.split()[0] for part in depends.split(',') if part.strip()}


PACKAGES = {field(p, 'Package'): p for p in glob.glob(os.path.join(FOLDER, '*.deb'))}


class Packages(unittest.TestCase):
    def unpacked(self, name):
        folder = tempfile.mkdtemp(prefix='penpose_package_')
        self.addCleanup(shutil.rmtree, folder)
        subprocess.run(['dpkg-deb', '-x', PACKAGES[name], folder], check=True)
        return folder

    def test_programs_are_packed(self):
        self.assertLessEqual({'penpose', 'penpose-nogui'}, set(PACKAGES))
        machines = {field(p, 'Architecture') for p in PACKAGES.values()} - {'all'}
        here = subprocess.run(['dpkg', '--print-architecture'], check=True, capture_output=True, text=True).stdout.strip()
        self.assertEqual(len(machines), 1)
        self.assertEqual(machines == {here}, not EMULATOR)

    def test_lintian_finds_no_error(self):
        for name, package in PACKAGES.items():
            done = subprocess.run(['lintian', '--fail-on', 'error', '--tag-display-limit', '0', package], capture_output=True, text=True)
            errors = [line for line in done.stdout.split('\n') if line.startswith('E:')]
            self.assertEqual((done.returncode, errors), (0, []), name + '\n' + done.stdout + done.stderr)

    @unittest.skipIf(EMULATOR, 'packages of another machine')
    def test_packages_ask_for_what_is_linked_and_nothing_else(self):
        """Held against dpkg-shlibdeps, which reads it from the program; what it cannot see is named here."""
        unseen = {'libegl1', 'libgl1', 'fonts-dejavu-core'}
        for name in ['penpose', 'penpose-nogui', 'libpenpose0']:
            if name not in PACKAGES:
                continue
            folder = self.unpacked(name)
            programs = glob.glob(folder + '/usr/bin/*') + [p for p in glob.glob(folder + '/usr/lib/**/*.so.*', recursive=True) if not os.path.islink(p)]
            work = os.path.join(folder, 'work')
            os.makedirs(os.path.join(work, 'debian'))
            with open(os.path.join(work, 'debian', 'control'), 'w') as file:
                file.write('Source: penpose\n\nPackage: %s\nArchitecture: any\n' % name)
            said = subprocess.run(['dpkg-shlibdeps', '-O', '--warnings=0'] + ['-e' + p for p in programs], cwd=work, check=True,
                                  capture_output=True, text=True).stdout.strip()
            needed = said.partition('shlibs:Depends=')[2]
            given = field(PACKAGES[name], 'Depends')
            self.assertEqual(names_in(given) - unseen, names_in(needed), '%s\n%s\n%s' % (name, given, needed))
            for part in needed.split(', '):
                least = re.match(r'(\S+) \(>= (.*)\)', part)
                asked = re.search(re.escape(least.group(1)) + r' \(>= ([^)]*)\)', given) if least else None
                if asked:
                    enough = subprocess.run(['dpkg', '--compare-versions', asked.group(1), 'ge', least.group(2)]).returncode
                    self.assertEqual(enough, 0, '%s asks for %s, needed is %s' % (name, asked.group(0), part))

    def test_the_headers_come_with_what_they_include(self):
        """What find_package(penpose) finds and links is there with the package that has it."""
        folder = self.unpacked('libpenpose-dev')
        found = []
        for path in glob.glob(folder + '/usr/lib/**/cmake/penpose/*.cmake', recursive=True):
            with open(path) as file:
                text = file.read()
            found += re.findall(r'(?<!if\(OFF\)\n  )find_dependency\((\w+)\)', text)
            for links in re.findall(r'INTERFACE_LINK_LIBRARIES "([^"]*)"', text):
                found += [link for link in links.split(';') if '::' not in link]
        packages = {'glm': 'libglm-dev', 'OpenMesh': 'libopenmesh-dev', 'xxhash': 'libxxhash-dev',
                    'meshoptimizer': 'libmeshoptimizer-dev', 'draco': 'libdraco-dev', 'pugixml': 'libpugixml-dev',
                    'z': 'zlib1g-dev', 'png': 'libpng-dev', 'jpeg': 'libjpeg-dev', 'webp': 'libwebp-dev'}
        wanted = {packages.get(name.removesuffix('Core').removesuffix('Tools'), name) for name in found if name != 'Threads'}
        self.assertIn('libglm-dev', wanted)
        self.assertEqual(names_in(field(PACKAGES['libpenpose-dev'], 'Depends')), wanted | {'libpenpose0'})

    def test_without_the_window_there_is_no_opengl(self):
        folder = self.unpacked('penpose-nogui')
        program = folder + '/usr/bin/penpose'
        run = EMULATOR + [program]
        linked = subprocess.run(['readelf', '-d', program], check=True, capture_output=True, text=True).stdout
        self.assertNotRegex(linked, r'NEEDED.*(SDL|epoxy|libGL|libEGL)')
        self.assertFalse(os.path.exists(folder + '/usr/share/applications'))
        done = subprocess.run(run + ['demo', '-o', folder + '/out'], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(os.listdir(folder + '/out')), ['demo.glb', 'demo.png'])
        done = subprocess.run(run + ['render', folder + '/out/demo.glb', '-o', folder + '/x.png'], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(folder + '/x.png', 'rb') as picture:
            self.assertEqual(picture.read(8), b'\x89PNG\r\n\x1a\n')
        done = subprocess.run(run, capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)

    def test_the_same_build_gives_the_same_package(self):
        again = FOLDER + '_again'
        shutil.rmtree(again, ignore_errors=True)
        os.makedirs(again)
        subprocess.run(['cpack', '--config', os.path.join(BUILD, 'CPackConfig.cmake'), '-B', again], check=True, stdout=subprocess.DEVNULL, cwd=again)
        for name, package in PACKAGES.items():
            first, second = [subprocess.run(['dpkg-deb', '--fsys-tarfile', p], check=True, capture_output=True).stdout
                             for p in (package, os.path.join(again, os.path.basename(package)))]
            names = [subprocess.run(['tar', '-t'], input=t, capture_output=True).stdout for t in (first, second)]
            self.assertEqual(names[0], names[1], name)
        shutil.rmtree(again)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
