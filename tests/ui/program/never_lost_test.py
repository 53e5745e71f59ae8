#!/usr/bin/env python3
"""Files that others made name what they like, and outputs fall on inputs: no device is read, nothing waits, and no file is lost.

usage: never_lost_test.py PENPOSE"""
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import hostile_seeds

PENPOSE = os.path.abspath(sys.argv.pop(1))
SESSION = '# penpose session edition=11 program=test\n# penpose model 0c1ed05de4985a1fef6863dc35986e2d path=%s\n# penpose do set_key time_s=0\n'
SOON_S = 20  # nothing here computes for long; what waits, waits for ever


def percent(path):
    return ''.join(c if c.isalnum() else '%%%02X' % ord(c) for c in path)


class NeverLost(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        hostile_seeds.helpers(self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), 'w', encoding='utf-8') as f:
            f.write(text)

    def run_it(self, *command, given=None):
        environment = {'PATH': '/usr/bin:/bin', 'HOME': self.folder, 'SDL_VIDEODRIVER': 'offscreen'}
        return subprocess.run([PENPOSE] + list(command), cwd=self.folder, env=environment, stdin=given or subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, timeout=SOON_S, check=False)

    def refused(self, done, what):
        self.assertEqual(done.returncode, 1, what)
        self.assertEqual(done.stderr.count('\n'), 1, (what, done.stderr))
        self.assertRegex(done.stderr, r'^penpose: .+; .+', what)

    def sums(self):
        """The content of all plain files."""
        sums = {}
        for name in sorted(os.listdir(self.folder)):
            if os.path.isfile(self.path(name)):
                with open(self.path(name), 'rb') as f:
                    sums[name] = hashlib.sha256(f.read()).hexdigest()
        return sums

    def test_a_session_names_a_device_or_a_pipe_as_its_model(self):
        os.mkfifo(self.path('pipe'))
        os.symlink('/dev/zero', self.path('link.glb'))
        for named in ('/dev/zero', self.path('pipe'), 'pipe', self.path('link.glb'), '/proc/kmsg', self.folder, '/dev/stdin'):
            self.write('a.session', SESSION % percent(named))
            self.refused(self.run_it('replay', 'a.session'), named)
            window = self.run_it('a.session')  # the same in the window
            self.refused(window, named)
            self.assertIn(os.path.basename(named), window.stderr, named)

    def test_what_a_file_names_lies_below_its_folder(self):
        secret = tempfile.NamedTemporaryFile(suffix='.bin')
        self.addCleanup(secret.close)
        secret.write(b'\0' * 4000)
        secret.flush()
        os.mkfifo(self.path('pipe.bin'))
        os.symlink(secret.name, self.path('link.bin'))
        os.symlink('/dev/zero', self.path('zero.bin'))
        for uri in ('/dev/zero', '../' + os.path.basename(secret.name), secret.name, 'pipe.bin', 'link.bin', 'zero.bin', 'file:///dev/zero', '.'):
            self.write('a.gltf', json.dumps({'asset': {'version': '2.0'}, 'buffers': [{'byteLength': 36, 'uri': uri}]}))
            self.refused(self.run_it('info', 'a.gltf'), uri)
            self.write('labels.json', json.dumps({'frames': [{'image': uri, 'curves': {'m': [[1, 1], [2, 2]]}}] * 2}))
            self.refused(self.run_it('track', 'a.pgm', '--labels', 'labels.json', '-o', 'o.json'), uri)

    def test_inputs_without_end_are_refused(self):
        for name in ('/dev/zero', '/dev/random', '/dev/tty', '/dev/full') + (('/proc/kmsg',) if os.access('/proc/kmsg', os.R_OK) else ()):
            for command in (['info', name], ['decode', name], ['replay', name], ['pose', 'face.glb', '--cases', name], [name],
                            ['animate', 'face.glb', '--track', name, '-o', 'o.glb'], ['track', name, '--labels', 'labels.json', '-o', 'o.json']):
                self.refused(self.run_it(*command), command)
        with open('/dev/zero', 'rb') as zeros:
            for command in (['info', '-'], ['decode', '-'], ['serve']):
                self.refused(self.run_it(*command, given=zeros), command)

    def test_no_output_falls_on_an_input_or_on_another_output(self):
        self.write('a.session', SESSION % percent('builtin:head'))
        shutil.copy(self.path('face.glb'), self.path('other.glb'))
        os.link(self.path('face.glb'), self.path('hard.glb'))
        os.symlink('face.glb', self.path('soft.glb'))
        os.symlink('new.glb', self.path('to_new.glb'))
        before = self.sums()
        for out in ('face.glb', './face.glb', 'hard.glb', 'soft.glb', self.path('face.glb')):
            for command in (['render', 'face.glb', '-o', out], ['pose', 'face.glb', '--cases', 'cases.json', '-o', out],
                            ['articulate', 'face.glb', '--sketch', 'sketch.json', '-o', out], ['suggest', 'face.glb', '--set', 'lift=0', '-o', out],
                            ['animate', 'face.glb', '--track', 'track.json', '--map', 'map.json', '-o', out],
                            ['replay', 'a.session', '--model', 'face.glb', '-o', out], ['convert', 'other.glb', '--shapes', 'face.glb', out],
                            ['replay', 'a.session', '--session', out]):
                self.refused(self.run_it(*command), command)
                self.assertEqual(self.sums(), before, command)
        for command in (['animate', 'face.glb', '--track', 'track.json', '--map', 'map.json', '-o', 'track.json'],
                        ['animate', 'face.glb', '--track', 'track.json', '--map', 'map.json', '-o', 'map.json'],
                        ['pose', 'face.glb', '--cases', 'cases.json', '-o', 'cases.json'], ['render', 'face.glb', '--camera', 'camera.json', '-o', 'camera.json'],
                        ['track', 'a.pgm', '--labels', 'labels.json', '-o', 'a.pgm'], ['track', 'a.pgm', '--labels', 'labels.json', '-o', 'labels.json'],
                        ['replay', 'a.session', '-o', 'a.session'], ['replay', 'a.session', '-o', 'new.glb', '--png', 'new.glb'],
                        ['replay', 'a.session', '-o', 'new.glb', '--png', 'to_new.glb'], ['replay', 'a.session', '-o', 'new.glb', '--session', 'new.glb'],
                        ['record', '-o', 'a.session']):
            self.refused(self.run_it(*command), command)
            self.assertEqual(self.sums(), before, command)
        # A model may be written over by itself.
        self.assertEqual(self.run_it('convert', 'other.glb', 'other.glb').returncode, 0)
        self.assertEqual(self.run_it('info', 'other.glb').returncode, 0)

    def test_what_killed_runs_left_goes_and_nothing_else(self):
        for name in ('.penpose-0123456789abcdef.part', '.penpose-notes.part', '.penpose-0123456789abcdef.part2'):
            self.write(name, 'x')
        self.assertEqual(self.run_it('convert', 'face.glb', 'out.glb').returncode, 0)
        self.assertEqual([name for name in sorted(os.listdir(self.folder)) if name.startswith('.penpose')],
                         ['.penpose-0123456789abcdef.part2', '.penpose-notes.part'])

    @unittest.skipUnless(os.geteuid() == 0, 'links of other users are made by root alone')
    def test_links_that_others_planted_are_not_followed(self):
        self.write('victim', 'as it was')
        os.chmod(self.folder, 0o1777)
        for name in ('out.glb', 'out.png', 'out.session'):
            os.symlink('victim', self.path(name))
            os.lchown(self.path(name), 65534, 65534)
        for command in (['convert', 'face.glb', 'out.glb'], ['render', 'face.glb', '--size', '32x32', '-o', 'out.png'],
                        ['replay', 'a.session', '--session', 'out.session'], ['serve', '--session', 'out.session']):
            self.refused(self.run_it(*command), command)
            with open(self.path('victim'), encoding='utf-8') as f:
                self.assertEqual(f.read(), 'as it was', command)

    def test_interrupted_while_it_writes_a_sequence_it_leaves_whole_files(self):
        hostile_seeds.face(self.path('face.glb'))
        command = [PENPOSE, 'render', 'face.glb', '--frames', '--fps', '400', '--size', '64x64', '-o', 'frame.png']
        with subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
            deadline = time.monotonic() + SOON_S
            while not os.path.exists(self.path('frame0003.png')) and run.poll() is None and time.monotonic() < deadline:
                time.sleep(0.005)
            run.terminate()
            run.wait(SOON_S)
        names = [name for name in os.listdir(self.folder) if name.startswith('frame')]
        self.assertGreater(len(names), 2)
        for name in names:
            with open(self.path(name), 'rb') as f:
                content = f.read()
            self.assertTrue(content.startswith(b'\x89PNG') and content.endswith(b'IEND\xaeB`\x82'), name)
        self.assertEqual([name for name in os.listdir(self.folder) if name.startswith('.penpose')], [])


if __name__ == '__main__':
    unittest.main()
