#!/usr/bin/env python3
"""examples_test.py PENPOSE MAKE_FILES SESSION TRACE: runs every example that a help ends with, as it stands there.

The files that they name are made first. Where no tablet is plugged in, `record` says so; it is run with a tablet by the tests
of firmware_io/device_mock and in the virtual machine."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PENPOSE, MAKE_FILES, SESSION, TRACE = [os.path.abspath(a) for a in sys.argv[1:5]]
WRITES = re.compile(r'(?:-o|--png|^penpose convert \S+) (\S+)')


def examples(*command):
    said = subprocess.run([PENPOSE, *command, '--help'], check=True, capture_output=True, text=True).stdout
    body, found, end = said.partition('\nExamples:\n')
    return [line.strip().split('  #')[0].strip() for line in end.strip().split('\n')] if found else []


def commands():
    said = subprocess.run([PENPOSE, '--help'], check=True, capture_output=True, text=True).stdout
    listed = said.partition('\nSubcommands:\n')[2].partition('\n\n')[0]
    return [line.split()[0] for line in listed.split('\n') if re.match(r'  \S', line)]


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix='penpose_examples_')
        subprocess.run([MAKE_FILES, cls.folder, '0'], check=True)
        shutil.copy(SESSION, os.path.join(cls.folder, 'drawn.session'))
        shutil.copy(TRACE, os.path.join(cls.folder, 'pen.hid'))
        bin_folder = os.path.join(cls.folder, '.bin')
        os.mkdir(bin_folder)
        os.symlink(PENPOSE, os.path.join(bin_folder, 'penpose'))
        cls.environment = dict(os.environ, PATH=bin_folder + ':' + os.environ['PATH'])
        for call in ['penpose animate face.glb --track track.json -o clip.glb',
                     'penpose convert face.glb posed.glb']:
            subprocess.run(call.split(), cwd=cls.folder, env=cls.environment, check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def run_example(self, call):
        if call.startswith('penpose record'):
            return self.run_record(call)
        # Each begins with the same files.
        folder = tempfile.mkdtemp(prefix='penpose_example_')
        self.addCleanup(shutil.rmtree, folder)
        shutil.copytree(self.folder, folder, symlinks=True, dirs_exist_ok=True)
        written = WRITES.findall(call)
        for path in written:
            full = os.path.join(folder, path)
            if os.path.isfile(full):
                os.remove(full)
        done = subprocess.run(['bash', '-c', call], cwd=folder, env=self.environment, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, call + '\n' + done.stderr)
        for path in written:
            there = os.path.exists(os.path.join(folder, path)) or any(
                os.path.exists(os.path.join(folder, stem + '0001.png')) for stem in (path, os.path.splitext(path)[0]))
            self.assertTrue(there, '%s wrote no %s' % (call, path))
        self.assertTrue(written or done.stdout, call + ' did nothing')

    def run_record(self, call):
        """Without a tablet it fails and says how to go on; with one it would record for as long as it may."""
        done = subprocess.run(['timeout', '-s', 'INT', '15', 'bash', '-c', 'exec ' + call], cwd=self.folder, env=self.environment,
                              capture_output=True, text=True)
        name = WRITES.search(call).group(1)
        if done.returncode == 0:
            self.assertTrue(os.path.exists(os.path.join(self.folder, name)))
        else:
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertRegex(done.stderr, r'^penpose: .*tablet')

    def test_every_command_has_two_and_they_run(self):
        names = commands()
        self.assertGreaterEqual(len(names), 13)
        for name in [None] + names:
            found = examples(*([name] if name else []))
            self.assertEqual(len(found), 2, 'the help of %s ends with two examples (ui/cli/examples.cpp)' % (name or 'penpose'))
            for call in found:
                with self.subTest(call):
                    self.assertTrue(name is None or call.startswith('penpose %s ' % name) or call == 'penpose ' + name, call)
                    self.run_example(call)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
