#!/usr/bin/env python3
"""Hostile runs: damaged files of every kind that the command line reads, special files in their place, little memory and few files,
outputs that take nothing, names and numbers nobody would give, and ends at any moment. Whatever happens, the program ends with 0, 1
or 2 in time, says why in one plain line with a remedy, keeps within the memory that its files are worth, and leaves inputs as they
were and outputs wholly old or wholly new.

usage: hostile_test.py PENPOSE [--runs N] [--seed S] [--jobs J] [--only GROUP] [--kind KIND] [--run K] [--keep FOLDER]

Run K of seed S is the same on every machine, whatever else runs: `--run K` repeats it alone and says what it did."""
import argparse
import collections
import json
import multiprocessing
import os
import random
import resource
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import time

import hostile_mutations
import hostile_seeds

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
MOST_S = 5.0           # of processor time; drawing and solving are in it
MOST_WALL_S = 60.0     # where it hangs, on a machine that is busy with other things
MOST_END_S = 10.0      # from a signal to the end; the window draws without a card and writes its session
MOST_BYTES = 50e6      # and 40 times the files
DRAWS_BYTES = 450e6    # what a driver that draws without a card takes for itself
WORKS_BYTES = 150e6    # the built-in head, its controls and the threads that solve
GROUPS = {'damaged': 62, 'special': 9, 'limits': 8, 'streams': 5, 'names': 6, 'numbers': 5, 'ended': 4, 'window': 1}
NOBODY = 65534
OLD = b'as it was'
MAGIC = {'.glb': b'glTF', '.png': b'\x89PNG', '.json': b'{', '.session': b'# '}


def pick(r, weighted):
    return r.choices(list(weighted), list(weighted.values()))[0]


class Run:
    """One hostile run in a folder of its own."""

    def __init__(self, penpose, seed, number, seeds, only=None):
        self.r = random.Random('%s:%s' % (seed, number))
        self.penpose, self.number, self.seeds = penpose, number, seeds
        self.group = pick(self.r, GROUPS)
        if only:
            self.group = only
        self.folder = tempfile.mkdtemp(prefix='penpose-hostile-')
        self.limits, self.streams, self.stop, self.input = {}, {}, None, None
        self.command, self.outputs, self.found = [], [], []
        # Whoever may do everything finds nothing locked.
        self.nobody = os.geteuid() == 0 and self.r.random() < 0.4

    def path(self, name):
        return os.path.join(os.fsencode(self.folder), os.fsencode(name))

    def choose(self, kinds=None):
        """A kind of file, one of its files and a command that reads it."""
        kind = self.r.choice([one for one in kinds or self.seeds if one in self.seeds] or list(self.seeds))
        name, content = self.r.choice(self.seeds[kind])
        return kind, name, content, list(self.r.choice(hostile_seeds.KINDS[kind][1]))

    def build(self):
        hostile_seeds.helpers(self.folder)
        shutil.copy(os.path.join(ROOT, 'fuzz/corpus/trace/plain'), self.path('pen.hid'))
        r = self.r
        kind, name, content, command = self.choose(['session', 'face', 'curve_track', 'trace', 'project'] if self.group == 'window' else None)
        name = 'x' + os.path.splitext(name)[1]
        damaged = self.group in ('damaged', 'window') or (self.group in ('limits', 'streams') and r.random() < 0.3)
        if damaged:
            content = hostile_mutations.mutate(content, name, r, [other for _, other in self.seeds[kind]])
        self.kind, out = kind, 'out'
        if self.group == 'names':
            name, out = self.odd_name(os.path.splitext(name)[1]), self.odd_name('')
        with open(self.path(name), 'wb') as f:
            f.write(content)
        if self.group == 'special':
            self.special(r.choice([name] + [a for a in command if os.path.exists(self.path(a))]))
        if self.group == 'window':
            command = ['{x}', '--session', '{out}.session'] if r.random() < 0.4 else ['{x}']
            self.stop = (r.uniform(1, 3), signal.SIGTERM)
        for argument in command:
            argument = os.fsencode(argument).replace(b'{x}', b'./' + os.fsencode(name) if os.fsencode(name)[:1] == b'-' else os.fsencode(name))
            if b'{out}' in argument:
                argument = argument.replace(b'{out}', b'./' + os.fsencode(out) if os.fsencode(out)[:1] == b'-' else os.fsencode(out))
                self.outputs.append(argument)
                if not argument.endswith(b'.session') and r.random() < 0.7:
                    try:
                        with open(self.path(argument), 'wb') as f:
                            f.write(OLD)
                    except OSError:
                        pass  # too long a name
            self.command.append(argument)
        if kind == 'serve':
            self.input = self.path(name)
            self.stop = (8, signal.SIGTERM)  # a thousand solves that were asked for take their time
        if self.group == 'limits':
            self.limit()
        if self.group == 'streams':
            self.spoil_streams()
        if self.group == 'numbers':
            self.number_options()
        if self.group == 'ended':
            self.stop = (r.uniform(0, 0.5), r.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGINT, signal.SIGTERM, signal.SIGHUP]))

    def odd_name(self, ending):
        r = self.r
        return r.choice([b'\x1b]0;x\x07' + b'a', b'a\nb', b'n' * r.choice([200, 246, 250, 255, 300]), b'\xff\xfe', '\u202eabc'.encode(), b'-', b'--help', b'a b',
                         b'%s%n%n', b'*', b'builtin', b'a\tb\x01', b'x.glb', b'.', b'"', b"'", b'\\', b'~', b'$HOME', 'ä\u0301'.encode()])[:255 - len(ending)] + ending.encode()

    def special(self, name):
        r, path = self.r, self.path(name)
        os.remove(path)
        what = r.randrange(13)
        if what == 0:
            os.mkfifo(path)
            self.stop = (0.6, signal.SIGTERM)
        elif what == 1:
            os.symlink('/dev/zero', path)
        elif what == 2:
            os.mkdir(path, r.choice([0o755, 0o000]))
        elif what == 3:
            os.symlink(os.path.basename(path), path)
        elif what == 4:
            os.symlink('nowhere', path)
        elif what == 5:
            open(path, 'wb').close()
        elif what == 6:
            with open(path, 'wb') as f:
                f.truncate(r.choice([1 << 20, 1 << 26, 1 << 40]))
        elif what == 7:
            os.symlink(r.choice(['/dev/full', '/dev/random', '/dev/tty', '/dev/stdin', '/proc/self/mem', '/proc/self/environ', '/proc/kmsg', '/etc']), path)
        elif what == 8:
            os.mknod(path, 0o600 | stat.S_IFSOCK)
        elif what == 9:
            pass  # it is not there
        elif what == 10:
            os.symlink('..', path)
        elif what == 12:
            open(path, 'wb').close()
            os.chmod(path, 0)
        else:
            with open(path, 'wb') as f:
                f.write(r.choice([b'\0', b'\n', b'{}', b'[]', b'""', b'\xef\xbb\xbf', b'\x1f\x8b\x08', b'%PDF', b'glTF', b'glTF\2\0\0\0\x0c\0\0\0', b'ply\n', b'solid', b'OFF',
                                  b'\x89PNG\r\n\x1a\n', b'P5', b'# penpose session 99\n', b'E: 0 1 00\n', b'{' * 100000, b'a' * 3000000]))

    def limit(self):
        r = self.r
        which = r.choice([resource.RLIMIT_AS] * 4 + [resource.RLIMIT_NOFILE, resource.RLIMIT_FSIZE, resource.RLIMIT_FSIZE, resource.RLIMIT_DATA,
                                                     resource.RLIMIT_NPROC, resource.RLIMIT_STACK])
        most = {resource.RLIMIT_AS: lambda: r.randrange(30, 900) << 20, resource.RLIMIT_NOFILE: lambda: r.randrange(4, 24),
                resource.RLIMIT_FSIZE: lambda: r.choice([0, 1, 100, 4096, 20000]), resource.RLIMIT_DATA: lambda: r.randrange(20, 300) << 20,
                resource.RLIMIT_NPROC: lambda: r.randrange(6), resource.RLIMIT_STACK: lambda: r.choice([256, 512, 1024]) << 10}[which]()
        self.limits[which] = most

    def spoil_streams(self):
        r = self.r
        self.streams = {number: r.choice(['full', 'closed', 'gone', 'null']) for number in (0, 1, 2) if r.random() < 0.6}

    def number_options(self):
        r, extreme = self.r, [b.decode() for b in hostile_mutations.NUMBERS] + ['99999999999999999999', '1x1', '0x0', '-1x5', '99999x99999', '8192x8192', 'axb']
        options = {'render': ['--time', '--size', '--fps', '--set'], 'animate': ['--neutral', '--tremor', '--smooth', '--confidence', '--fps', '--picture', '--tolerance'],
                   'replay': ['--stroke', '--tolerance'], 'suggest': ['--every', '--strength', '--set', '--hold'], 'convert': ['--fps', '--tolerance'],
                   'pose': ['--tolerance', '--free', '--form', '--preset', '--case'], 'track': ['--fps'], 'articulate': ['--tolerance', '--preset'],
                   'decode': ['--protocol'], 'info': ['--none'], 'devices': ['--rules-folder'], 'serve': ['--none']}
        for _ in range(r.choice([1, 1, 2])):
            option, value = r.choice(options[self.command[0].decode()]), r.choice(extreme)
            self.command += [option.encode(), (r.choice(['lift=', 'lean=', '=', '', 'x=']) + value if option in ('--set', '--hold') else value).encode()]

    def child(self):
        os.setsid()
        if self.nobody:
            os.setgroups([])
            os.setgid(NOBODY)
            os.setuid(NOBODY)
        for number, how in self.streams.items():
            if how == 'closed':
                os.close(number)
            elif how == 'gone':
                a, b = os.pipe()
                os.close(a if number else b)
                os.dup2(b if number else a, number)
            else:
                os.dup2(os.open('/dev/' + how, os.O_RDWR), number)
        for which, most in self.limits.items():
            resource.setrlimit(which, (most, most))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    def execute(self):
        environment = {'PATH': '/usr/bin:/bin', 'HOME': self.folder, 'SDL_VIDEODRIVER': 'offscreen', 'SDL_AUDIODRIVER': 'dummy', 'LC_ALL': self.r.choice(['C', 'C.UTF-8'])}
        environment.update({key: os.environ[key] for key in ('ASAN_OPTIONS', 'UBSAN_OPTIONS') if key in os.environ})
        if self.nobody:
            subprocess.run(['chown', '-RPh', str(NOBODY), self.folder], check=True)
        before = self.look()
        self.size = sum(os.lstat(self.path(name)).st_size for name in before)
        log = [tempfile.TemporaryFile() for _ in range(2)]
        with open(self.input or os.devnull, 'rb') if not self.input or os.path.isfile(self.input) else open(os.devnull, 'rb') as given:
            started = time.monotonic()
            process = subprocess.Popen([self.penpose] + self.command, stdin=given, stdout=log[0], stderr=log[1], cwd=self.folder, env=environment,
                                       preexec_fn=self.child, close_fds=True)
        asked, ended = None, 0
        while not ended:
            ended, status, usage = os.wait4(process.pid, os.WNOHANG)
            now = time.monotonic() - started
            if ended:
                break
            if self.stop and asked is None and now > self.stop[0]:
                os.kill(process.pid, self.stop[1])  # send_signal() takes away the status of one that has just ended
                asked = now
            if now > MOST_WALL_S or (asked and now > asked + MOST_END_S):
                os.kill(process.pid, signal.SIGKILL)
                self.find('hangs' if asked is None else 'does not end when asked to')
                os.wait4(process.pid, 0)
                process.returncode = -9
                return
            time.sleep(0.004 if now < 0.3 else 0.02)
        process.returncode = code = os.waitstatus_to_exitcode(status)
        self.end_s = now - asked if asked is not None else 0
        texts = []
        for f in log:
            f.seek(0)
            texts.append(f.read())
            f.close()
        self.judge(code, texts[0], texts[1], usage, asked is not None, before)

    def find(self, what, said=b''):
        self.found.append((what, said[-600:].decode('utf-8', 'backslashreplace')))

    def look(self):
        """Every file of the folder with what is in it; large ones by their size."""
        seen = {}
        for name in os.listdir(os.fsencode(self.folder)):
            facts = os.lstat(self.path(name))
            if stat.S_ISREG(facts.st_mode):
                with open(self.path(name), 'rb') as f:
                    seen[name] = f.read() if facts.st_size < 1 << 26 else facts.st_size
            else:
                seen[name] = facts.st_mode
        return seen

    def judge(self, code, out, said, usage, was_asked, before):
        self.code, self.seconds = code, usage.ru_utime + usage.ru_stime
        drawing = self.command[0] == b'render' or b'--png' in self.command or self.group == 'window'
        full_output = self.streams.get(1) in ('full', 'closed', 'gone')
        allowed = {0, 1, 2} | ({-self.stop[1]} if self.stop and was_asked else set()) | ({-signal.SIGPIPE} if 'gone' in self.streams.values() else set())
        if self.limits:
            allowed.add(127)  # the loader itself found no room
        if code not in allowed:
            self.find('ends with %d' % code, said)
        if code in (1, 2) and 2 not in self.streams and resource.RLIMIT_FSIZE not in self.limits:
            rows = said.decode('utf-8', 'replace').splitlines()
            if not rows or not rows[-1].startswith('penpose: ') or not said.endswith(b'\n'):
                self.find('no last line that says why', said)
            elif '; ' not in rows[-1]:
                self.find('no remedy', said)
            if len(rows) > 60:
                self.find('more than 60 lines', said)
            if any(len(row) > 1200 for row in rows):
                self.find('a line of more than 1200 letters', said)
        if code == 0 and said and any(not row.startswith('penpose: ') and self.command[0] != b'serve' for row in said.decode('utf-8', 'replace').splitlines()):
            self.find('a note that is not a line of the program', said)
        for text in (out, said):
            bad = [c for c in text if (c < 32 and c not in (10,)) or c == 127]
            if bad and self.command[0] != b'decode':
                self.find('control characters %r' % bytes(bad[:6]), text)
        try:
            (out + b'' if self.command[0] == b'decode' else out + said).decode('utf-8')
        except UnicodeDecodeError:
            self.find('not UTF-8', said or out)
        if code == 0 and b'--json' in self.command and not full_output and 1 not in self.streams and self.limits.get(resource.RLIMIT_FSIZE) is None:
            try:
                json.loads(out)
            except ValueError:
                self.find('--json is no JSON', out)
        if code == 0 and full_output and self.streams.get(1) != 'gone' and self.command[0] in (b'info', b'decode', b'replay', b'devices') and self.group == 'streams':
            self.find('failed output is called success', said)
        if code not in (127,) and not self.limits:
            most = 40 * self.size + MOST_BYTES + (DRAWS_BYTES if drawing else 0) + WORKS_BYTES
            if usage.ru_maxrss * 1024 > most:
                self.find('memory %.0f of %.0f MB' % (usage.ru_maxrss / 1e3, most / 1e6), said)
            if self.seconds > MOST_S + self.size / 100e6 + (self.stop[0] if self.stop else 0) and self.group != 'window':
                self.find('%.1f s' % self.seconds, said)
        self.judge_files(code, before, full_output)

    def judge_files(self, code, before, full_output):
        after = self.look()
        outputs = {os.path.normpath(name) for name in self.outputs}
        for name, content in before.items():
            if name in outputs:
                continue
            if name not in after or (after[name] != content):
                self.find('input %r changed' % name)
        for name, content in after.items():
            if name.startswith(b'.penpose-') and not (self.stop and self.stop[1] == signal.SIGKILL):
                self.find('left over: %r' % name)
            elif name not in before and name not in outputs and not name.startswith((b'.local', b'.config', b'.cache', b'saved', b'.penpose-')):
                # A conversation names what it saves.
                if not (self.group == 'window' and name.endswith((b'.open', b'.glb'))) and self.command[0] != b'serve':
                    self.find('a file nobody asked for: %r' % name)
        for name in outputs:
            content = after.get(name)
            if content is None or isinstance(content, int) or content == before.get(name):
                if code == 0 and self.group != 'window' and isinstance(before.get(name, OLD), bytes) and self.command[0] != b'serve':
                    self.find('success without an output %r' % name)
                continue
            magic = MAGIC.get(os.path.splitext(name)[1].decode('latin-1'), b'')
            if not content.startswith(magic) and not name.endswith(b'.session'):
                self.find('output %r is broken: %r' % (name, content[:40]))
            # A model that is written without a change is the file that was read, whatever its header says.
            kept = any(content == one for one in before.values())
            if name.endswith(b'.glb') and not kept and len(content) != int.from_bytes(content[8:12], 'little'):
                self.find('output %r is cut' % name)
            if code in (1, 2) and before.get(name) == OLD and not full_output and b'replay' != self.command[0]:
                self.find('refused, and %r is written all the same' % name)

    def story(self):
        return 'run %d %s/%s: %s%s%s%s' % (self.number, self.group, getattr(self, 'kind', ''), b' '.join(self.command)[:400].decode('utf-8', 'backslashreplace'),
                                          ' limits %s' % self.limits if self.limits else '', ' streams %s' % self.streams if self.streams else '',
                                          ' stop %s' % (self.stop,) if self.stop else '') + (' as nobody' if self.nobody else '')


def one(job):
    penpose, seed, number, only, keep, seeds = job
    run = Run(penpose, seed, number, SEEDS if seeds is None else seeds, only)
    try:
        run.build()
        run.execute()
        code = getattr(run, 'code', None)
        if keep and run.found:
            shutil.copytree(run.folder, os.path.join(keep, 'run%d' % number), symlinks=True, dirs_exist_ok=True,
                            ignore=lambda folder, names: [n for n in names if not os.path.isfile(os.path.join(folder, n))])
        return number, run.group, getattr(run, 'kind', ''), code, run.story(), run.found, getattr(run, 'seconds', 0), getattr(run, 'end_s', 0) if run.group == 'ended' else 0
    finally:
        subprocess.run(['chmod', '-R', 'u+rwX', run.folder], stderr=subprocess.DEVNULL, check=False)
        shutil.rmtree(run.folder, ignore_errors=True)


def main():
    global SEEDS
    parser = argparse.ArgumentParser()
    parser.add_argument('penpose')
    parser.add_argument('--runs', type=int, default=160)
    parser.add_argument('--seed', default='1')
    parser.add_argument('--jobs', type=int, default=2)
    parser.add_argument('--only', choices=list(GROUPS))
    parser.add_argument('--kind', action='append', choices=list(hostile_seeds.KINDS))
    parser.add_argument('--run', type=int)
    parser.add_argument('--keep')
    given = parser.parse_args()
    SEEDS = hostile_seeds.load(ROOT, os.path.abspath(given.penpose))
    SEEDS = {kind: files for kind, files in SEEDS.items() if not given.kind or kind in given.kind}
    numbers = [given.run] if given.run is not None else range(given.runs)
    jobs = [(os.path.abspath(given.penpose), given.seed, number, given.only, given.keep, None) for number in numbers]
    counts, codes, failed, slowest, began = collections.Counter(), collections.Counter(), 0, 0.0, time.time()
    with multiprocessing.get_context('fork').Pool(given.jobs) as pool:
        for number, group, kind, code, story, found, seconds, end_s in pool.imap_unordered(one, jobs):
            counts[group] += 1
            slowest = max(slowest, end_s)
            codes['signal' if code is not None and code < 0 else code] += 1
            if given.run is not None:
                print(story, '->', code, '%.2f s' % seconds)
            if found:
                failed += 1
                print('FAIL', story, '->', code)
                for what, said in found:
                    print('     %s%s' % (what, ': ' + repr(said) if said else ''), flush=True)
    print('%d runs in %.0f s: %s; ended with %s; at most %.2f s from a signal to the end; %d found something' % (
        sum(counts.values()), time.time() - began, ', '.join('%s %d' % pair for pair in sorted(counts.items())),
        ', '.join('%s: %d' % (code, count) for code, count in sorted(codes.items(), key=str)), slowest, failed))
    return 1 if failed else 0


SEEDS = {}
if __name__ == '__main__':
    sys.exit(main())
