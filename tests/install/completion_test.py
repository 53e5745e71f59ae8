#!/usr/bin/env python3
"""completion_test.py PREFIX: completes in bash, zsh and fish, with the files that were installed below PREFIX.

In bash and zsh keys are typed into a terminal, Tab and all; a function called `penpose` prints the arguments that come out."""
import glob
import os
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

PREFIX = os.path.abspath(sys.argv[1])


def installed(pattern):
    found = glob.glob(os.path.join(PREFIX, pattern))
    assert len(found) == 1, (pattern, found)
    return found[0]


class Terminal:
    """A shell in a terminal."""

    def __init__(self, command, folder):
        environment = {'PATH': os.environ['PATH'], 'HOME': folder, 'TERM': 'dumb', 'PS1': 'READY> ', 'LC_ALL': 'C.UTF-8'}
        self.child, self.end = pty.fork()
        if self.child == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, environment)

    def read_until(self, pattern, seconds=90):
        text, stop = '', time.monotonic() + seconds
        while time.monotonic() < stop:
            if select.select([self.end], [], [], 0.2)[0]:
                try:
                    text += os.read(self.end, 65536).decode(errors='replace')
                except OSError:
                    break
                if re.search(pattern, text):
                    return text
        raise AssertionError('no %r in %r' % (pattern, text))

    def type(self, keys):
        os.write(self.end, keys.encode())

    def close(self):
        self.type('\nexit\n')
        deadline = time.monotonic() + 10
        while os.waitpid(self.child, os.WNOHANG)[0] == 0 and time.monotonic() < deadline:
            time.sleep(0.05)
        os.close(self.end)


# What is typed before Tab, and what comes out.
CASES = [
    ('penpose rend', ['render']),
    ('penpose dev', ['devices']),
    ('penpose --full', ['--fullscreen']),
    ('penpose render --wire', ['render', '--wireframe']),
    ('penpose render face.glb --view thr', ['render', 'face.glb', '--view', 'three-quarter']),
    ('penpose pose face.glb --preset ex', ['pose', 'face.glb', '--preset', 'exact']),
    ('penpose info fa', ['info', 'face.glb']),
    ('penpose replay dr', ['replay', 'drawn.session']),
    ('penpose demo -o o', ['demo', '-o', 'out']),
    ('penpose pose face.glb --cases c', ['pose', 'face.glb', '--cases', 'cases.json']),
]


class Completion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='penpose_completion_')
        # For each, another file that begins alike and does not fit.
        for name in ['face.glb', 'fable.txt', 'drawn.session', 'drum.wav', 'cases.json', 'clip.mov', 'other.txt']:
            open(os.path.join(self.folder, name), 'w').close()
        os.mkdir(os.path.join(self.folder, 'out'))

    def tearDown(self):
        shutil.rmtree(self.folder)

    def complete_in_terminal(self, command, setup):
        shell = Terminal(command, self.folder)
        try:
            shell.read_until('> |% |# ')
            for line in setup:
                shell.type(line + '\n')
            shell.type('echo be""gin\n')
            shell.read_until('begin')
            for typed, wanted in CASES:
                with self.subTest(typed):
                    shell.type(typed + '\t')
                    time.sleep(0.3)
                    shell.type('\n')
                    got = re.search(r'GOT:<(.*?)>', shell.read_until(r'GOT:<[^$]*?>')).group(1)
                    # A shell may put a slash after a folder.
                    self.assertEqual([word.rstrip('/') for word in got.split('|')[:-1]], wanted)
        finally:
            shell.close()

    def test_bash(self):
        self.complete_in_terminal(
            ['bash', '--norc', '--noprofile', '-i'],
            ["bind 'set bell-style none'", "bind 'set enable-bracketed-paste off'",
             "penpose() { printf 'GOT:''<'; printf '%s|' \"$@\"; echo '>'; }",
             'source ' + installed('share/bash-completion/completions/penpose')])

    def test_zsh(self):
        folder = os.path.dirname(installed('share/zsh/*/_penpose'))
        self.complete_in_terminal(
            ['zsh', '-f', '-i'],
            ['unsetopt beep zle_bracketed_paste 2>/dev/null; unset zle_bracketed_paste', 'fpath=(%s $fpath)' % folder,
             'autoload -U compinit; compinit -u -D', "penpose() { printf 'GOT:''<'; printf '%s|' \"$@\"; echo '>' }"])

    def test_fish(self):
        script = installed('share/fish/vendor_completions.d/penpose.fish')
        for typed, wanted in CASES:
            with self.subTest(typed):
                done = subprocess.run(['fish', '--no-config', '-c', 'function penpose; end; source %s; complete -C %s' %
                                       (script, "'" + typed + "'")], cwd=self.folder, capture_output=True, text=True,
                                      env={'PATH': os.environ['PATH'], 'HOME': self.folder, 'LC_ALL': 'C.UTF-8'})
                self.assertEqual(done.stderr, '')
                lines = done.stdout.strip().split('\n')
                self.assertEqual(len(lines), 1, done.stdout)
                self.assertEqual(lines[0].split('\t')[0].rstrip('/'), wanted[-1], done.stdout)

    def test_no_choice_is_lost(self):
        """Everything that a help lists is offered: the words of --view in all three."""
        for script in ['share/bash-completion/completions/penpose', 'share/zsh/*/_penpose', 'share/fish/vendor_completions.d/penpose.fish']:
            with open(installed(script)) as file:
                text = file.read()
            self.assertIn('front side three-quarter back top', text, script)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
