#!/usr/bin/env python3
"""install_test.py BUILD PREFIX: installs BUILD below PREFIX and looks at what is there: the program runs from there, the desktop's
files pass their validators, pages render without a warning."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, PREFIX = [os.path.abspath(a) for a in sys.argv[1:3]]
shutil.rmtree(PREFIX, ignore_errors=True)
subprocess.run(['cmake', '--install', BUILD, '--prefix', PREFIX, '--component', 'penpose'], check=True, stdout=subprocess.DEVNULL)
PENPOSE = os.path.join(PREFIX, 'bin', 'penpose')


def path(*parts):
    return os.path.join(PREFIX, *parts)


def run(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, **more)


def pages():
    return sorted(os.listdir(path('share', 'man', 'man1')))


class Installed(unittest.TestCase):
    def test_what_is_there(self):
        for name in ['bin/penpose', 'lib/udev/rules.d/70-penpose.rules', 'share/applications/org.penpose.penpose.desktop',
                     'share/metainfo/org.penpose.penpose.metainfo.xml', 'share/mime/packages/penpose.xml',
                     'share/icons/hicolor/scalable/apps/penpose.svg', 'share/icons/hicolor/256x256/apps/penpose.png',
                     'share/man/man1/penpose.1', 'share/bash-completion/completions/penpose',
                     'share/fish/vendor_completions.d/penpose.fish', 'share/doc/penpose/copyright']:
            self.assertTrue(os.path.isfile(path(name)), name)

    def test_it_runs_without_the_sources(self):
        """With neither sources nor build in sight: another folder, no environment to speak of."""
        done = run(PENPOSE, 'replay', path('share', 'penpose', 'sessions', 'demo.session'), '--json', cwd='/', env={})
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(PENPOSE, 'rb') as program:
            content = program.read()
        for folder in [BUILD, os.path.dirname(BUILD)]:
            self.assertNotIn((folder + '/ui/').encode(), content, 'the program knows where it was built')
        self.assertNotIn(b'RUNPATH', run('readelf', '-d', PENPOSE).stdout.encode())

    def test_every_command_has_its_page_and_they_have_no_warnings(self):
        said = run(PENPOSE, '--help').stdout.partition('\nSubcommands:\n')[2].partition('\n\n')[0]
        commands = [line.split()[0] for line in said.split('\n') if re.match(r'  \S', line)]
        self.assertEqual(pages(), sorted(['penpose.1'] + ['penpose-%s.1' % c for c in commands]))
        for page in pages():
            full = path('share', 'man', 'man1', page)
            rendered = run('man', '--warnings', '-E', 'UTF-8', '-l', '-Tutf8', '-Z', full,
                           env=dict(os.environ, LC_ALL='C.UTF-8', MANROFFSEQ='', MANWIDTH='80'))
            self.assertEqual((rendered.returncode, rendered.stderr), (0, ''), page)
            linted = run('mandoc', '-Tlint', '-Wwarning', full)
            self.assertEqual((linted.returncode, linted.stdout), (0, ''), page)

    def test_pages_say_what_help_says(self):
        """Every option of every help stands in its page, and nothing else does."""
        for page in pages():
            command = page[len('penpose-'):-2].split()
            told = run(PENPOSE, *command, '--help').stdout.partition('\nExamples:')[0]
            wanted = set(re.findall(r'^  (?:-\w,)?(--[\w-]+)', told, re.M)) | set(re.findall(r'^  (-\w)[ ,]', told, re.M))
            with open(path('share', 'man', 'man1', page)) as file:
                source = file.read().replace('\\-', '-')
            options = source.partition('.SH OPTIONS\n')[2].partition('\n.SH')[0]
            found = {name for head in re.findall(r'\.TP\n(.*)\n', options) for name in re.findall(r'\\fB(--?[\w-]+)\\fR', head)}
            self.assertEqual(found, wanted, page)

    def test_validators(self):
        done = run('desktop-file-validate', path('share', 'applications', 'org.penpose.penpose.desktop'))
        self.assertEqual((done.returncode, done.stdout + done.stderr), (0, ''))
        done = run('appstreamcli', 'validate', '--no-net', path('share', 'metainfo', 'org.penpose.penpose.metainfo.xml'))
        self.assertEqual(done.returncode, 0, done.stdout)

    @unittest.skipUnless(shutil.which('systemd-analyze'), 'systemd is not installed')
    def test_systemd_understands_the_unit(self):
        with open(path('share', 'penpose', 'boards', 'penpose.service'), encoding='utf-8') as f:
            unit = re.sub(r'ExecStart=\S+', 'ExecStart=' + PENPOSE, f.read())
        with tempfile.TemporaryDirectory() as folder:
            copy = os.path.join(folder, 'penpose.service')
            with open(copy, 'w', encoding='utf-8') as f:
                f.write(unit)
            verified = run('systemd-analyze', 'verify', '--man=no', copy)
        self.assertEqual((verified.returncode, verified.stderr), (0, ''))

    def test_types_are_told(self):
        """Sessions are known by what they begin with, projects by their ending; a plain .glb stays one."""
        data = path('share')
        self.assertEqual(run('update-mime-database', os.path.join(data, 'mime')).returncode, 0)
        folder = path('typed')
        os.makedirs(folder)
        session = path('share', 'penpose', 'sessions', 'demo.session')
        for name in ['a.session', 'no_ending']:
            shutil.copy(session, os.path.join(folder, name))
        for name in ['b.penpose.glb', 'c.glb']:
            with open(os.path.join(folder, name), 'wb') as file:
                file.write(b'glTF\x02\0\0\0')
        environment = dict(os.environ, XDG_DATA_DIRS=data + ':/usr/share', XDG_DATA_HOME=folder)
        for name, wanted in [('a.session', 'application/x-penpose-session'), ('no_ending', 'application/x-penpose-session'),
                             ('b.penpose.glb', 'application/x-penpose-project'), ('c.glb', 'model/gltf-binary')]:
            told = run('gio', 'info', '-a', 'standard::content-type', os.path.join(folder, name), env=environment).stdout
            self.assertEqual(re.search('content-type: (.*)', told).group(1), wanted, name)

    def test_pictures_have_their_sizes(self):
        for size in [16, 24, 32, 48, 64, 128, 256]:
            with open(path('share/icons/hicolor/%dx%d/apps/penpose.png' % (size, size)), 'rb') as file:
                head = file.read(24)
            self.assertEqual(head[:8], b'\x89PNG\r\n\x1a\n')
            self.assertEqual([int.from_bytes(head[16:20], 'big'), int.from_bytes(head[20:24], 'big')], [size, size])


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
