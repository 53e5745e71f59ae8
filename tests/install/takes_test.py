#!/usr/bin/env python3
"""takes_test.py PENPOSE MAKE_FILES SCRIPTS SESSION: the scripts of docs/takes over a folder of takes, as the page tells: together
as one after the other, killed and begun again, with a take that is broken, checked, and as a task of an array."""
import hashlib
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PENPOSE, MAKE_FILES, SCRIPTS, SESSION = [os.path.abspath(a) for a in sys.argv[1:5]]
TAKES = 4


def content(folder):
    """What is in a folder, by hash; the log of the scheduler, which tells times, is left out."""
    out = {}
    for base, _, names in os.walk(folder):
        for name in names:
            full = os.path.join(base, name)
            if name != 'log':
                with open(full, 'rb') as file:
                    out[os.path.relpath(full, folder)] = hashlib.sha256(file.read()).hexdigest()
    return out


class Takes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix='penpose_takes_')
        subprocess.run([MAKE_FILES, cls.folder, str(TAKES)], check=True)
        shutil.copy(SESSION, os.path.join(cls.folder, 'takes', 'drawn.session'))
        os.mkdir(os.path.join(cls.folder, 'bin'))
        os.symlink(PENPOSE, os.path.join(cls.folder, 'bin', 'penpose'))
        cls.environment = dict(os.environ, PATH=os.path.join(cls.folder, 'bin') + ':' + os.environ['PATH'], LP_NUM_THREADS='0')
        cls.takes = sorted(os.listdir(os.path.join(cls.folder, 'takes')))
        for take in cls.takes:
            cls.sh('take.sh', 'face.glb', 'takes/' + take, 'one', check=True)
        cls.wanted = content(os.path.join(cls.folder, 'one'))

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    @classmethod
    def sh(cls, script, *arguments, check=False, **more):
        environment = dict(cls.environment, **more)
        return subprocess.run(['sh', os.path.join(SCRIPTS, script), *arguments], cwd=cls.folder, env=environment, check=check,
                              capture_output=True, text=True)

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def test_each_take_has_its_files(self):
        for take in self.takes:
            name = take.partition('.')[0]
            self.assertIn(name + '.glb', self.wanted)
            with open(self.path('one', name + '.state')) as file:
                self.assertRegex(file.read(), r'^[0-9a-f]{32}\n$')
            self.assertIn(name + '.png' if take.endswith('.session') else name + '/0008.png', self.wanted)

    def test_together_as_one_after_the_other(self):
        done = self.sh('all.sh', 'face.glb', 'takes', 'together', '--jobs', '2')
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(content(self.path('together')), self.wanted)
        with open(self.path('together', 'log')) as log:
            self.assertEqual(len(log.readlines()), 1 + len(self.takes))
        written = {name: os.stat(self.path('together', name)).st_mtime_ns for name in self.wanted}
        self.assertEqual(self.sh('all.sh', 'face.glb', 'takes', 'together', '--jobs', '2').returncode, 0)
        self.assertEqual(written, {name: os.stat(self.path('together', name)).st_mtime_ns for name in self.wanted},
                         'what is done is not done again')
        self.assertEqual(self.sh('check.sh', 'together', *['takes/' + t for t in self.takes]).returncode, 0)

    def test_killed_anywhere_and_run_again(self):
        """The job is killed, children and all, after ever longer; nothing half is left, and the end is as without."""
        dice = random.Random(19)
        take = self.takes[1]
        name = take.partition('.')[0]
        killed = 0
        begun = time.monotonic()
        self.sh('take.sh', 'face.glb', 'takes/' + take, 'timed', check=True)
        whole = time.monotonic() - begun
        for _ in range(12):
            job = subprocess.Popen(['sh', os.path.join(SCRIPTS, 'take.sh'), 'face.glb', 'takes/' + take, 'killed'], cwd=self.folder,
                                   env=self.environment, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(dice.uniform(0.02, whole))
            ended = job.poll() is not None
            if not ended:
                os.killpg(job.pid, signal.SIGKILL)
                killed += 1
            job.wait()
            for there, found in (content(self.path('killed')) if os.path.exists(self.path('killed')) else {}).items():
                if not os.path.basename(there).startswith('.'):
                    self.assertEqual(found, self.wanted[there], there + ' is whole')
            if ended:
                shutil.rmtree(self.path('killed'))  # what is done is not done again
        self.assertGreater(killed, 3)
        self.sh('take.sh', 'face.glb', 'takes/' + take, 'killed', check=True)
        self.assertEqual(content(self.path('killed')),
                         {there: found for there, found in self.wanted.items() if there.startswith((name + '.', name + '/'))})

    def test_a_broken_take_is_one_failure_and_is_done_when_mended(self):
        shutil.copytree(self.path('takes'), self.path('broken'))
        with open(self.path('broken', self.takes[2]), 'r+') as file:
            whole = file.read()
            file.seek(0)
            file.truncate()
            file.write(whole[:len(whole) // 2])
        done = self.sh('all.sh', 'face.glb', 'broken', 'mended', '--jobs', '2', PICTURES='no')
        self.assertEqual(done.returncode, 1, 'parallel ends with the number of jobs that failed')
        self.assertIn(self.takes[2], done.stderr)
        check = self.sh('check.sh', 'mended', *['broken/' + t for t in self.takes])
        self.assertEqual((check.returncode, check.stdout), (1, self.takes[2].partition('.')[0] + ': not done\n'))
        with open(self.path('broken', self.takes[2]), 'w') as file:
            file.write(whole)
        self.assertEqual(self.sh('all.sh', 'face.glb', 'broken', 'mended', '--jobs', '2', PICTURES='no').returncode, 0)
        found = content(self.path('mended'))
        self.assertEqual(found, {k: v for k, v in self.wanted.items() if not k.endswith('.png')})

    def test_check_finds_another_state(self):
        shutil.copytree(self.path('one'), self.path('other'))
        first, second = [t.partition('.')[0] for t in self.takes[1:3]]
        shutil.copy(self.path('other', first + '.glb'), self.path('other', second + '.glb'))
        check = self.sh('check.sh', 'other', *['takes/' + t for t in self.takes])
        self.assertEqual(check.returncode, 1)
        self.assertRegex(check.stdout, '^%s: holds another state' % second)

    def test_tasks_of_an_array(self):
        """As Slurm starts them: one process a task, told by its number which take is its own."""
        for number in range(len(self.takes)):
            done = subprocess.run(['bash', os.path.join(SCRIPTS, 'array.sbatch'), 'face.glb', 'takes', 'farm'], cwd=self.folder,
                                  env=dict(self.environment, SLURM_ARRAY_TASK_ID=str(number), SLURM_SUBMIT_DIR=SCRIPTS, PICTURES='no'),
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(content(self.path('farm')), {k: v for k, v in self.wanted.items() if not k.endswith('.png')})


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
