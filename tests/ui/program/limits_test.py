#!/usr/bin/env python3
"""The program under hard conditions: outputs that take nothing, little memory, interrupts, names that no file has. Whatever
happens, it ends with 0, 1 or 2, says why in one line, and leaves files that were there whole.

usage: limits_test.py PENPOSE"""
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PENPOSE = os.path.abspath(sys.argv.pop(1))
CASES = ('{"cases": [{"name": "a", "references": [{"vertices": [0, 1, 2], "target": [[0, 0, 0], [0.1, 0, 0], [0.2, 0.1, 0]]}]}]}')
TRACK = '{"fps":25,"frames":[%s]}' % ','.join(
    '{"curves":{"brow_R":[%s]}}' % ','.join('[%d,%d]' % (100 + 10 * i, 100 + k) for i in range(5)) for k in range(3))
SESSION = '# penpose session edition=11 program=test\n# penpose model 0c1ed05de4985a1fef6863dc35986e2d path=builtin%3Ahead\n# penpose do set_key time_s=0\n'


class Limits(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        for name, text in (('cases.json', CASES), ('track.json', TRACK), ('a.session', SESSION)):
            with open(self.path(name), 'w', encoding='utf-8') as f:
                f.write(text)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def printing(self):
        """Commands that print what they have to say on standard output."""
        return [['info', 'builtin:head'], ['info', 'builtin:head', '--json'], ['replay', self.path('a.session')],
                ['replay', self.path('a.session'), '--json'], ['demo', '-o', self.path('demo')], ['demo', '-o', self.path('demo'), '--json'],
                ['devices', '--known'], ['devices', '--known', '--json'], ['devices', '--udev-rule'],
                ['pose', 'builtin:head', '--cases', self.path('cases.json'), '--json'],
                ['animate', 'builtin:demo', '--track', self.path('track.json'), '-o', self.path('clip.glb'), '--json'],
                ['animate', 'builtin:demo', '--track', self.path('track.json'), '-o', self.path('clip.glb')], ['--help'], ['--version']]

    def refusal_of_output(self, text, what):
        """Once, and last, whatever there was to say about the work before."""
        self.assertEqual(text.count('penpose: standard output: '), 1, '%s: %r' % (what, text))
        self.assertTrue(text.splitlines()[-1].startswith('penpose: standard output: '), '%s: %r' % (what, text))

    def one_line(self, text, what):
        self.assertEqual(text.count('\n'), 1, '%s: %r' % (what, text))
        self.assertTrue(text.startswith('penpose: '), '%s: %r' % (what, text))

    def test_output_that_is_not_taken_is_no_success(self):
        for command in self.printing():
            with open('/dev/full', 'wb') as full:
                done = subprocess.run([PENPOSE] + command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(done.returncode, 1, command)
            self.refusal_of_output(done.stderr, command)

    def test_a_closed_output_is_no_success_and_no_file_takes_its_place(self):
        for command in self.printing():
            done = subprocess.run(['sh', '-c', 'exec "$@" >&-', 'sh', PENPOSE] + command, stderr=subprocess.PIPE, text=True, check=False)
            self.assertEqual(done.returncode, 1, command)
            self.refusal_of_output(done.stderr, command)
        # Nor does what is printed get into a file that is written.
        out = self.path('out.glb')
        subprocess.run(['sh', '-c', 'exec "$@" <&- >&- 2>&-', 'sh', PENPOSE, 'convert', 'builtin:head', out], check=False)
        with open(out, 'rb') as f:
            self.assertEqual(f.read(4), b'glTF')

    def test_a_command_that_prints_nothing_needs_no_output(self):
        done = subprocess.run(['sh', '-c', 'exec "$@" >&-', 'sh', PENPOSE, 'convert', 'builtin:head', self.path('x.glb')], check=False)
        self.assertEqual(done.returncode, 0)

    def test_standard_streams_are_files_where_that_makes_sense(self):
        model = subprocess.run([PENPOSE, 'convert', 'builtin:head', '-'], stdout=subprocess.PIPE, check=True).stdout
        self.assertEqual(model[:4], b'glTF')
        said = subprocess.run([PENPOSE, 'info', '-'], input=model, stdout=subprocess.PIPE, check=True).stdout
        self.assertIn(b'vertices    1', said)
        picture = subprocess.run([PENPOSE, 'render', '-', '--size', '64x64', '-o', '-'], input=model, stdout=subprocess.PIPE, check=True)
        self.assertEqual(picture.stdout[:4], b'\x89PNG')
        both = subprocess.run([PENPOSE, 'pose', 'builtin:head', '--cases', self.path('cases.json'), '-o', '-'], stderr=subprocess.PIPE,
                              text=True, check=False)
        self.assertEqual(both.returncode, 1)
        self.one_line(both.stderr, 'a model in between what is printed')

    def test_little_memory_is_one_line_and_old_files_stay_whole(self):
        commands = [['info', 'builtin:demo'], ['convert', 'builtin:demo', self.path('old')], ['render', 'builtin:head', '-o', self.path('old')],
                    ['demo', '-o', self.path('demo')], ['replay', self.path('a.session'), '-o', self.path('old.glb')],
                    ['animate', 'builtin:demo', '--track', self.path('track.json'), '-o', self.path('old.glb')]]
        short = 0
        for megabytes in (40, 60, 80, 100, 130, 160, 200, 250, 300, 350, 400, 450, 500, 600, 700):
            for command in commands:
                for name in ('old', 'old.glb'):
                    with open(self.path(name), 'wb') as f:
                        f.write(b'as it was')

                def limit(most=megabytes << 20):
                    resource.setrlimit(resource.RLIMIT_AS, (most, most))
                    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
                done = subprocess.run([PENPOSE] + command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, preexec_fn=limit,
                                      check=False)
                if done.returncode == 127:
                    continue  # the loader itself found no room
                what = '%s with %d MB' % (command[0], megabytes)
                self.assertIn(done.returncode, (0, 1), what + ': ' + done.stderr)
                if done.returncode == 1:
                    short += 1
                    self.one_line(done.stderr, what)
                    if command[0] != 'demo':
                        for name in ('old', 'old.glb'):
                            with open(self.path(name), 'rb') as f:
                                self.assertEqual(f.read(), b'as it was', what)
        self.assertGreater(short, 5, 'memory was never short')

    @unittest.skipUnless(os.geteuid() == 0, 'root alone can become a user who runs nothing else')
    def test_threads_that_cannot_be_started_are_one_line(self):
        nobody = 65534
        os.chmod(self.folder.name, 0o777)
        picture = ['render', 'builtin:head', '--size', '64x64', '-o', self.path('x.png')]
        by_card = picture + ['--draw', 'gl']
        for command in (picture, by_card, ['info', 'builtin:head'], ['pose', 'builtin:head', '--cases', self.path('cases.json')],
                        ['demo', '-o', self.path('demo')]):
            for most in (0, 1, 2):
                def limit(most=most):
                    os.setgroups([])
                    os.setgid(nobody)
                    os.setuid(nobody)
                    resource.setrlimit(resource.RLIMIT_NPROC, (most, most))
                done = subprocess.run([PENPOSE] + command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, preexec_fn=limit,
                                      timeout=60, check=False)
                self.assertIn(done.returncode, (0, 1), (command, done.stderr))
                if done.returncode == 1:
                    self.one_line(done.stderr, command)
                if command == by_card and os.cpu_count() > 1:
                    self.assertEqual(done.returncode, 1, 'as many threads as processors are not there')
                if command == picture:
                    self.assertEqual(done.returncode, 0, 'the processor draws with one')

    def test_what_may_be_written_to_is_little(self):
        for megabytes in (20, 30, 45, 60, 90, 150):
            for command in (['render', 'builtin:head', '--size', '64x64', '-o', self.path('x.png')], ['info', 'builtin:demo']):
                def limit(most=megabytes << 20):
                    resource.setrlimit(resource.RLIMIT_DATA, (most, most))
                done = subprocess.run([PENPOSE] + command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, preexec_fn=limit,
                                      timeout=60, check=False)
                self.assertIn(done.returncode, (0, 1), (megabytes, command, done.stderr))
                if done.returncode == 1:
                    self.one_line(done.stderr, command)

    def test_an_interrupt_ends_it_at_once(self):
        pipe = self.path('pipe')
        os.mkfifo(pipe)
        with open(self.path('slow.session'), 'w', encoding='utf-8') as f:
            f.write('D: 0\nN: pen\nI: 3 056a 0061\nE: 000000.0 1 00\nE: 000600.0 1 00\n')
        # Something that reads from a pipe to which nothing is written.
        for command in (['info', pipe], ['decode', pipe], ['replay', self.path('slow.session'), '--realtime', '--model', 'builtin:head'],
                        ['pose', 'builtin:head', '--cases', pipe], ['info', '-']):
            for number in (signal.SIGINT, signal.SIGTERM):
                with subprocess.Popen([PENPOSE] + command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
                    time.sleep(0.4)
                    self.assertIsNone(run.poll(), command)
                    before = time.monotonic()
                    run.send_signal(number)
                    run.wait(5)
                    self.assertLess(time.monotonic() - before, 0.1, command)

    def test_names_that_no_file_has_are_one_line(self):
        loop = self.path('loop')
        os.symlink('loop', loop)
        for name in ('n' * 300, loop, loop + '/x', '/' + 'd/' * 3000, self.path('cases.json') + '/x', ''):
            for command in (['info', name], ['decode', name], ['replay', name], ['render', name, '-o', self.path('x.png')],
                            ['pose', 'builtin:head', '--cases', name], ['animate', 'builtin:demo', '--track', name, '-o', self.path('x.glb')],
                            ['convert', 'builtin:head', '--shapes', name, self.path('x.glb')],
                            ['track', name, '--labels', name, '-o', self.path('x.json')], ['demo', '-o', name + '/x' if name else loop]):
                done = subprocess.run([PENPOSE] + command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
                self.assertIn(done.returncode, (1, 2), (command, done.stderr))
                self.one_line(done.stderr, command)

    def test_help_and_refusals_are_plain_text(self):
        for command in (['pose', '--help'], ['pose', 'x', '--cases', 'y', '--form', 'zzz'], ['pose', 'x', '--cases', 'y', '--free', 'a\x1b[2J'],
                        ['replay', 'x', '--stroke', '99999999999999999999'], ['info', '\x1b]0;title\a.glb'], ['--no\x1b']):
            done = subprocess.run([PENPOSE] + command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            self.assertEqual([c for c in done.stdout + done.stderr if c < 32 and c != 10], [], (command, done.stderr))
            if '--help' not in command:
                self.assertNotEqual(done.returncode, 0, command)
                self.one_line(done.stderr.decode(), command)


if __name__ == '__main__':
    unittest.main()
