"""The disk of a board: the program as it is installed, the libraries that it needs, and the init that starts it."""
import os
import shutil
import subprocess

import machine

FONT = '/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf'
SYSTEMD_PACKAGES = ('systemd systemd-sysv udev dbus dbus-daemon dbus-system-bus-common libpam-systemd libpam-modules libpam-modules-bin libpam-runtime '
                    'login mount util-linux').split()
LEFT_OUT = ('/usr/share/doc/', '/usr/share/man/', '/usr/share/locale/', '/usr/share/zsh/', '/usr/share/bash-completion/', '/usr/lib/udev/hwdb.d/')
MERGED = ('/bin/', '/sbin/', '/lib/', '/lib64/')
USER = 999  # the user and the group penpose
GROUPS = dict(root=0, adm=4, tty=5, disk=6, lp=7, kmem=15, dialout=20, cdrom=24, tape=26, audio=29, shadow=42, utmp=43, video=44, kvm=104, render=105,
              sgx=106, input=107, messagebus=108, penpose=USER)
MEMBERS = ('video', 'render', 'input')  # as penpose.service says
PASSWD = f"""root:x:0:0:root:/root:/bin/sh
messagebus:x:108:108::/nonexistent:/usr/sbin/nologin
penpose:x:{USER}:{USER}::/home/penpose:/bin/sh
"""
DRAWING = """[Unit]
Description=A pen that draws in the window
[Service]
ExecStart=/bin/sh /drawing.sh
[Install]
WantedBy=multi-user.target
"""


def missing_packages():
    """Of those that a board with systemd has."""
    return [p for p in SYSTEMD_PACKAGES
            if 'ok installed' not in subprocess.run(['dpkg-query', '-W', '-f', '${Status}', p], capture_output=True, text=True).stdout]


class Board:
    """The folder that becomes the disk."""

    def __init__(self, folder):
        self.folder, self.root = folder, os.path.join(folder, 'board')
        shutil.rmtree(self.root, ignore_errors=True)
        for name in ('bin', 'sbin', 'lib', 'lib64'):
            os.makedirs(os.path.join(self.root, 'usr', name))
            os.symlink('usr/' + name, os.path.join(self.root, name))
        for name in ('proc', 'sys', 'dev', 'run', 'tmp', 'var', 'out', 'root', 'home/penpose', 'etc'):
            os.makedirs(os.path.join(self.root, name))

    def place(self, path):
        target = self.root + ('/usr' + path if path.startswith(MERGED) else path)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        return target

    def put(self, path, content):
        with open(self.place(path), 'w', encoding='utf-8') as f:
            f.write(content)

    def link(self, path, to):
        target = self.place(path)
        if not os.path.lexists(target):
            os.symlink(to, target)

    def add(self, source, path=None):
        """A file of this machine and the libraries that it needs, where they are here or at another path."""
        target = self.place(path or source)
        if os.path.lexists(target):
            return
        shutil.copy(os.path.realpath(source), target)
        with open(target, 'rb') as f:
            is_program = f.read(4) == b'\x7fELF'
        for library in machine.libraries(source) if is_program else ():
            self.add(library)

    def add_package(self, name):
        """What a package of Debian's has put onto this machine, but for what is there to be read by people."""
        for path in subprocess.run(['dpkg-query', '-L', name], capture_output=True, text=True, check=True).stdout.splitlines():
            if self.place(path)[len(self.root):].startswith(LEFT_OUT) or path.endswith('.efi.stub'):
                continue
            if os.path.islink(path):
                self.link(path, os.readlink(path))
            elif os.path.isfile(path) and os.access(path, os.R_OK):
                self.add(path)

    def install(self, build):
        """The component with the window, by the build's own rules of installation; gives where it says that a board's files are."""
        told = subprocess.run(['cmake', '--install', build, '--component', 'penpose', '--strip'], check=True, capture_output=True, text=True,
                              env=dict(os.environ, DESTDIR=self.root)).stdout
        installed = [line.split(': ', 1)[1] for line in told.splitlines() if line.startswith('-- Installing: ')]
        program, unit = (next(p for p in installed if p.endswith(end)) for end in ('/bin/penpose', '/boards/penpose.service'))
        for library in machine.libraries(program):
            self.add(library)
        self.add(FONT)
        return os.path.dirname(unit)

    def add_busybox(self):
        shutil.copy(machine.find('busybox'), self.place('/usr/bin/busybox'))  # a static one
        for name in subprocess.run([machine.find('busybox'), '--list'], capture_output=True, text=True, check=True).stdout.split():
            self.link(f'/usr/lib/busybox/{name}', '/usr/bin/busybox')
        for name in ('/bin/sh', '/usr/bin/env'):
            self.link(name, '/usr/bin/busybox')
        for name in ('functions.sh', 'drawing.sh'):
            self.add(os.path.join(machine.HERE, 'guest', name), '/' + name)

    def start_by_busybox(self, boards):
        self.link('/sbin/init', '/usr/bin/busybox')
        with open(os.path.join(boards, 'inittab.line'), encoding='utf-8') as f:
            self.put('/etc/inittab', f.read() + '::once:/bin/sh /drawing.sh\n')

    def start_by_systemd(self, boards):
        """Debian's systemd, udev and logind, a console at tty1 as Debian has it, and the unit, enabled as its first lines say."""
        for package in SYSTEMD_PACKAGES:
            self.add_package(package)
        for name in os.listdir('/etc/pam.d'):
            self.add('/etc/pam.d/' + name)
        self.put('/etc/passwd', PASSWD)
        self.put('/etc/shadow', ''.join(line.split(':')[0] + ':!:19000::::::\n' for line in PASSWD.splitlines()))
        self.put('/etc/group', ''.join(f'{name}:x:{number}:{"penpose" if name in MEMBERS else ""}\n' for name, number in GROUPS.items()))
        self.put('/etc/machine-id', '0123456789abcdef0123456789abcdef\n')
        # The pen's event device is the group's before its hidraw node is the session's.
        self.put('/etc/udev/rules.d/60-late.rules', 'SUBSYSTEM=="hidraw", KERNELS=="*:2D1F:*", PROGRAM="/usr/lib/busybox/sleep 3"\n')
        self.put('/etc/systemd/system/drawing.service', DRAWING)
        shutil.copy(os.path.join(boards, 'penpose.service'), self.place('/etc/systemd/system/penpose.service'))
        self.link('/etc/systemd/system/getty.target.wants/getty@tty1.service', '/lib/systemd/system/getty@.service')
        self.link('/etc/systemd/system/serial-getty@ttyS0.service', '/dev/null')  # the tests' own
        for name in ('drawing', 'penpose'):
            self.link(f'/etc/systemd/system/multi-user.target.wants/{name}.service', f'/etc/systemd/system/{name}.service')
        self.link('/etc/systemd/system/default.target', '/lib/systemd/system/multi-user.target')

    def image(self, size_mb):
        image = os.path.join(self.folder, 'board.img')
        if os.path.exists(image):
            os.unlink(image)
        subprocess.run([machine.find('mke2fs'), '-q', '-t', 'ext4', '-O', '^has_journal', '-d', self.root, image, f'{size_mb}M'], check=True)
        return image
