"""A virtual machine of Debian's kernel and a minimal initramfs, started, talked to and ended by a test."""
import argparse
import glob
import io
import json
import os
import shutil
import socket
import subprocess
import sys
import tarfile
import time
import unittest

import kernel_image

HERE = os.path.dirname(os.path.abspath(__file__))
MODULES = ('virtio_pci virtio_console hid hid-generic uhid evdev usbhid wacom hid-uclogic hid-multitouch hid-ntrig '
           'xhci-pci vhci-hcd').split()
NEEDED = {'qemu-system-x86_64': 'qemu-system-x86', 'cpio': 'cpio', 'modprobe': 'kmod', 'busybox': 'busybox-static'}
# Programs that lie where they lay the last time need not be translated again. This processor has one clock and no holes
# to close; its timer comes late where the machine around it is busy, which is no fault of it.
KERNEL_OPTIONS = ('console=ttyS0 loglevel=4 panic=-1 rdinit=/init norandmaps nokaslr mitigations=off tsc=reliable '
                  'rodata=off lsm= audit=0 cryptomgr.notests no_timer_check oops=panic')


def find(program):
    return shutil.which(program, path=os.environ.get('PATH', '') + ':/usr/sbin:/sbin')


def kernel():
    """The newest kernel with its modules: release and image, or nothing."""
    images = [(os.stat(i).st_mtime, i) for i in glob.glob('/boot/vmlinuz-*') if os.access(i, os.R_OK)]
    for _, image in sorted(images, reverse=True):
        release = image[len('/boot/vmlinuz-'):]
        if os.path.isdir(f'/lib/modules/{release}'):
            return release, image
    return None


def missing():
    """Names of the packages that are not installed."""
    packages = {package for program, package in NEEDED.items() if not find(program)}
    if not kernel():
        packages.add('linux-image-amd64')
    return sorted(packages)


def skip_if_missing(files=()):
    """Ends the test as skipped where a package or one of these files is missing."""
    lacking = [f for f in files if not os.path.exists(f)]
    if lacking or missing():
        print(f'SKIPPED: no virtual machine without these: {" ".join(missing() + lacking)}; install packages with: '
              f'apt-get install {" ".join(missing())}')
        sys.exit(77)


def libraries(program):
    """What a program needs to be loaded, by path."""
    for line in subprocess.run(['ldd', program], capture_output=True, text=True, check=True).stdout.splitlines():
        for word in line.split():
            if word.startswith('/'):
                yield word


def build_initramfs(folder, programs, files, modules=MODULES, loaded=()):
    """programs: paths of executables for /bin. files: {path in the machine: content}. modules: of the kernel. loaded: files
    that programs load by name while they run; they stand where they stand here. Gives the path of the archive."""
    release, _ = kernel()
    root = os.path.join(folder, 'root')
    shutil.rmtree(root, ignore_errors=True)
    for d in ('bin', 'lib64', 'lib/modules'):
        os.makedirs(os.path.join(root, d), exist_ok=True)
    shutil.copy(find('busybox'), os.path.join(root, 'bin/busybox'))
    for program in programs:
        target = os.path.join(root, 'bin', os.path.basename(program))
        shutil.copy(program, target)
        subprocess.run(['strip', target], check=False)
        for library in libraries(program):
            loader = library.startswith('/lib64/')
            shutil.copy(os.path.realpath(library), os.path.join(root, 'lib64' if loader else 'lib', os.path.basename(library)))
    for source in loaded:
        target = root + source
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copy(os.path.realpath(source), target)
        for library in libraries(source) if '.so' in source else ():
            shutil.copy(os.path.realpath(library), os.path.join(root, 'lib', os.path.basename(library)))
    files = dict(files, **{'/modules.list': '\n'.join(modules) + '\n'})
    for name in modules:
        shown = subprocess.run([find('modprobe'), '-S', release, '--show-depends', name], capture_output=True, text=True).stdout
        needed = [line.split()[1] for line in shown.splitlines() if line.startswith('insmod')]
        for module in needed:
            shutil.copy(module, os.path.join(root, 'lib/modules'))
        files[f'/modules/{name}'] = ''.join(f'/lib/modules/{os.path.basename(module)}\n' for module in needed)
    shutil.copy(os.path.join(HERE, 'guest/init'), os.path.join(root, 'init'))
    os.chmod(os.path.join(root, 'init'), 0o755)
    shutil.copy(os.path.join(HERE, 'guest/functions.sh'), root)
    for path, content in files.items():
        target = root + path
        os.makedirs(os.path.dirname(target), exist_ok=True)
        with open(target, 'wb') as f:
            f.write(content if isinstance(content, bytes) else content.encode())
    return pack(folder)


def pack(folder):
    """The archive of what is in the folder's `root`."""
    root = os.path.join(folder, 'root')
    names = subprocess.run(['find', '.'], cwd=root, capture_output=True, check=True).stdout
    archive = os.path.join(folder, 'initramfs')
    with open(archive, 'wb') as f:
        subprocess.run([find('cpio'), '-o', '-H', 'newc', '--quiet'], cwd=root, input=names, stdout=f, check=True)
    return archive


class Machine:
    def __init__(self, folder, archive, limit_s=900, memory=768, processors=1, devices=(), disk=None):
        self.folder, self.limit = folder, time.monotonic() + limit_s
        self.console, self.out, self.live = (os.path.join(folder, n) for n in ('console', 'out.tar', 'live'))
        for path in (self.console, self.out, self.live):
            open(path, 'wb').close()
        control = os.path.join(folder, 'qmp')
        if os.path.exists(control):
            os.unlink(control)
        image = kernel_image.unpacked(kernel()[1], folder)
        # Plain emulation: /dev/kvm may exist and yet hang where this is a virtual machine itself.
        acceleration = os.environ.get('PENPOSE_VM_ACCEL', 'tcg')
        self.process = subprocess.Popen(
            [find('qemu-system-x86_64'), '-accel', acceleration, '-cpu', 'max', '-smp', str(processors), '-m', str(memory), '-nodefaults', '-no-reboot',
             '-display', 'none', '-kernel', image, '-initrd', archive, '-append', KERNEL_OPTIONS,
             '-serial', f'file:{self.console}', '-device', 'virtio-serial-pci',
             '-chardev', f'file,id=out,path={self.out}', '-device', 'virtserialport,chardev=out,nr=1',
             '-chardev', f'file,id=live,path={self.live}', '-device', 'virtserialport,chardev=live,nr=2',
             '-device', 'qemu-xhci,id=usb', '-qmp', f'unix:{control},server=on,wait=off'] +
            [word for device in devices for word in ('-device', device)] +
            (['-drive', f'file={disk},if=virtio,format=raw,snapshot=on'] if disk else []))
        self.qmp = None
        self.control = control

    def left(self):
        return self.limit - time.monotonic()

    def text(self):
        with open(self.console, 'rb') as f:
            return f.read().decode(errors='replace')

    def wait(self, condition, what, seconds=None):
        """Waits until the condition holds; the end of the machine or of the time is a failure."""
        until = time.monotonic() + (seconds or self.left())
        while not condition():
            if self.process.poll() is not None and not condition():
                raise RuntimeError(f'the machine ended before: {what}\n{self.text()[-3000:]}')
            if min(self.left(), until - time.monotonic()) < 0:
                raise RuntimeError(f'no time left for: {what}\n{self.text()[-3000:]}')
            time.sleep(0.005)

    def wait_for_mark(self, mark, seconds=180):
        self.wait(lambda: f'MARK {mark}' in self.text(), f'mark {mark}', seconds)

    def command(self, name, **arguments):
        if self.qmp is None:
            self.wait(lambda: os.path.exists(self.control), 'its control socket')
            self.socket = socket.socket(socket.AF_UNIX)
            self.socket.connect(self.control)
            self.qmp = self.socket.makefile('r')
            self.qmp.readline()
            self.command('qmp_capabilities')
        self.socket.sendall(json.dumps({'execute': name, 'arguments': arguments}).encode() + b'\n')
        while True:
            answer = json.loads(self.qmp.readline())
            if 'error' in answer:
                raise RuntimeError(f'{name}: {answer["error"]}')
            if 'return' in answer:
                return answer['return']

    def results(self):
        """Waits for the end and gives what the machine left in /out, by name."""
        self.wait(lambda: self.process.poll() is not None, 'its end')
        with open(self.out, 'rb') as f:
            archive = tarfile.open(fileobj=io.BytesIO(f.read()))
        return {os.path.normpath(m.name): archive.extractfile(m).read() for m in archive if m.isfile()}

    def end(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()


def parser_of(*required):
    """The options that tests have: these are texts and have to be given."""
    parser = argparse.ArgumentParser()
    for option in required:
        parser.add_argument('--' + option, required=True)
    return parser


def archive_of(options, job, tools, files, *more):
    """The initramfs of guest/JOB.sh with the program, where there is one, and these tools."""
    os.makedirs(options.work, exist_ok=True)
    with open(os.path.join(HERE, f'guest/{job}.sh'), encoding='utf-8') as f:
        files = {**files, '/job.sh': f.read()}
    programs = [options.penpose] if hasattr(options, 'penpose') else []
    return build_initramfs(options.work, programs + [os.path.join(options.tools, tool) for tool in tools], files, *more)


def ran(options, archive, **of_machine):
    """What a machine that nobody talks to left, by name, and what its console said."""
    vm = Machine(options.work, archive, **of_machine)
    try:
        results = vm.results()
    finally:
        console = vm.text()
        print(console[-1500:], flush=True)
        vm.end()
    return results, console


def keep(results, *folders):
    """Writes them into each of these folders that is one."""
    for folder in filter(None, folders):
        os.makedirs(folder, exist_ok=True)
        for name, content in results.items():
            with open(os.path.join(folder, name), 'wb') as f:
                f.write(content)


class LeftBehind(unittest.TestCase):
    """Tests of what a machine left, which `results` is to be set to."""
    results = {}

    def text(self, name):
        self.assertIn(name, sorted(self.results), 'the machine left no such file')
        return self.results[name].decode(errors='replace').strip()

    def listed(self, name):
        return json.loads(self.text(name + '.json'))['tablets']
