#!/usr/bin/env bash
# root_test.sh FOLDER ARCHITECTURE HASHES PACKAGE...: in a fresh minimal Debian 12 of ARCHITECTURE (debootstrap, kept as an archive in
# FOLDER) installs the .deb files, runs the demo, replays the bundled session to its golden state, purges all again, and looks
# what is left. As root, over the network; machines other than this one in QEMU's emulation. Ends with 77 where there is
# neither a mirror nor an emulation to be had.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
architecture=$2
hashes=$3
shift 3
leave_out() { echo "left out: $1"; exit 77; }
[ "$(id -u)" = 0 ] || leave_out "a root can be changed by root alone"
command -v debootstrap >/dev/null || leave_out "debootstrap is not installed"

# Programs of another machine run where the kernel knows their interpreter. It is told for the time of the test, and the
# interpreter stays open (F), so that it need not lie in the root.
handler=/proc/sys/fs/binfmt_misc/penpose-test-$architecture
register() {
  local magic=$1 interpreter=$2
  [ -e /proc/sys/fs/binfmt_misc/register ] || mount -t binfmt_misc none /proc/sys/fs/binfmt_misc 2>/dev/null ||
    leave_out "the kernel takes no other machines' programs"
  [ ! -e "$handler" ] || echo -1 >"$handler"
  # e_ident without its padding, the type (2 or 3), and the machine.
  echo ":${handler##*/}:M::\x7fELF$magic:\xff\xff\xff\xff\xff\xff\xff\x00\xff\xff\xff\xff\xff\xff\xff\xff\xfe\xff\xff\xff:$interpreter:F" \
    >/proc/sys/fs/binfmt_misc/register
}
if [ "$architecture" != "$(dpkg --print-architecture)" ]; then
  case $architecture in
    arm64) bits='\x02\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\xb7\x00' name=aarch64 ;;
    armhf) bits='\x01\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\x28\x00' name=arm ;;
    *) leave_out "$architecture is not emulated" ;;
  esac
  command -v qemu-$name-static >/dev/null || leave_out "qemu-user-static is not installed"
  register "$bits" "$(command -v qemu-$name-static)"
fi

root=$(mktemp -d "$folder/root-$architecture.XXXXXX")
finish() {
  for place in proc dev; do ! mountpoint -q "$root/$place" || umount "$root/$place"; done
  rm -rf --one-file-system "$root"
  [ ! -e "$handler" ] || echo -1 >"$handler"
}
trap finish EXIT

archive=$folder/bookworm-$architecture.tar
if [ ! -e "$archive" ]; then
  mirror=$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' 'Created-By: Packages' | awk '$1 == "bookworm" {print $2; exit}')
  [ -n "$mirror" ] || leave_out "apt knows no mirror of Debian 12"
  debootstrap --variant=minbase --arch="$architecture" bookworm "$root" "$mirror" >"$folder/debootstrap-$architecture.log" 2>&1 ||
    { tail -n 3 "$folder/debootstrap-$architecture.log"; leave_out "the root cannot be made"; }
  tar -C "$root" --one-file-system -cf "$archive.part" .
  mv "$archive.part" "$archive"
else
  tar -C "$root" -xf "$archive"
fi
cp /etc/resolv.conf "$root/etc/resolv.conf"
mount -t proc proc "$root/proc"
inside() { env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$root" "$@"; }
# All paths but those of the package tools' own records; what a program keeps in a home is its user's.
listed() { (cd "$root" && find . -xdev \( -path ./var/lib/apt -o -path ./var/cache -o -path ./var/log -o -path ./var/lib/dpkg -o -path ./proc -o -path ./tmp -o -path ./root \) -prune -o -print | sort); }

inside apt-get -o Acquire::Check-Valid-Until=false -o Acquire::Check-Date=false update -qq >/dev/null 2>&1 || leave_out "no packages can be had in the root"
listed >"$folder/before-$architecture"
mkdir "$root/tmp/packages"
cp "$@" "$root/tmp/packages"
names=()
for package in "$@"; do names+=("$(dpkg-deb -f "$package" Package)"); done
inside sh -c 'apt-get install -y -qq --no-install-recommends /tmp/packages/*.deb' >"$folder/apt-$architecture.log" 2>&1 ||
  { tail -n 15 "$folder/apt-$architecture.log"; echo "FAILED: the packages do not install"; exit 1; }

inside sh -c 'cd /tmp && penpose demo -o demo' >"$folder/demo-$architecture.log" || { echo "FAILED: the demo"; exit 1; }
tail -n 1 "$folder/demo-$architecture.log"
state=$(inside penpose replay /usr/share/penpose/sessions/demo.session --json | sed -n 's/.*"state": *"\([0-9a-f]*\)".*/\1/p')
golden=$(awk '$1 == "demo.session" {print $2}' "$hashes")
[ "$state" = "$golden" ] || { echo "FAILED: the session ends in $state, golden is $golden"; exit 1; }
echo "state $state, as golden"
[ -s "$root/tmp/demo/demo.glb" ] || { echo "FAILED: the demo wrote nothing"; exit 1; }
case " ${names[*]} " in *" python3-penpose "*)
  state=$(inside python3 -c 'import penpose
with open("/usr/share/penpose/sessions/demo.session", "rb") as file: print(penpose.play(file.read())[0].state)')
  [ "$state" = "$golden" ] || { echo "FAILED: in Python the session ends in $state, golden is $golden"; exit 1; }
  echo "the same in Python" ;;
esac

inside apt-get purge -y -qq "${names[@]}" >>"$folder/apt-$architecture.log" 2>&1
inside apt-get autoremove -y -qq --purge >>"$folder/apt-$architecture.log" 2>&1
listed >"$folder/after-$architecture"
left=$(comm -13 "$folder/before-$architecture" "$folder/after-$architecture")
records=$(cd "$root" && grep -l penpose var/lib/dpkg/status var/lib/dpkg/info/* 2>/dev/null || true)
if [ -n "$left$records" ]; then
  printf 'FAILED: this is left:\n%s\n%s\n' "$left" "$records"
  exit 1
fi
echo "nothing is left"
