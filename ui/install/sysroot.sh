#!/usr/bin/env bash
# sysroot.sh ARCHITECTURE FOLDER [PACKAGE...]: Debian's libraries of another machine (arm64, armhf) in FOLDER, to build against
# and to run what was built in emulation. Without PACKAGE all that the program is built from. Downloads with debootstrap from
# where apt does; the machine itself stays as it is. What is there already is not fetched again. Ends with 1 where the packages
# cannot be had.
set -euo pipefail
architecture=$1
folder=$(mkdir -p "$2" && cd "$2" && pwd)
shift 2
[ $# -gt 0 ] || set -- libxxhash-dev zlib1g-dev libtinygltf-dev libmeshoptimizer-dev libdraco-dev libpugixml-dev libglm-dev libcli11-dev libsdl2-dev libepoxy-dev libdrm-dev libpng-dev libjpeg-dev libwebp-dev \
  libhidapi-dev libusb-1.0-0-dev libevdev-dev libimgui-dev libstb-dev libfontconfig-dev

# What they run with, and the C library of the same release.
set -- libc6 libgcc-s1 libstdc++6 "$@"
complete=$folder/complete-$(cksum <<<"$*" | cut -d ' ' -f 1)
[ -e "$complete" ] && exit 0
command -v debootstrap >/dev/null || { echo "debootstrap is not installed" >&2; exit 1; }
mirror=$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' 'Created-By: Packages' | awk '$1 == "bookworm" {print $2; exit}')
[ -n "$mirror" ] || { echo "apt knows no mirror of Debian 12" >&2; exit 1; }
downloads=$(mktemp -d "$folder.XXXXXX")
trap 'rm -rf "$downloads"' EXIT
IFS=,
debootstrap --download-only --variant=minbase --arch="$architecture" --include="$*" bookworm "$downloads" "$mirror" >"$folder.log" 2>&1 ||
  { tail -n 3 "$folder.log" >&2; exit 1; }
rm -rf "$folder"
mkdir -p "$folder"
for package in "$downloads"/var/cache/apt/archives/*.deb; do
  case ${package##*/} in
    # The cross compiler has its own, and these name files of a machine that runs.
    libc6-dev_*|linux-libc-dev_*|libcrypt-dev_*|libnsl-dev_*|libtirpc-dev_*) continue ;;
    # Drivers of graphics cards, sound and print servers: nothing is linked with them, and they are most of it.
    libllvm*|libgl1-mesa-dri*|libicu*|libx265*|perl*|coreutils*|python*|gcc-*) continue ;;
  esac
  dpkg -x "$package" "$folder"
done
touch "$complete"
