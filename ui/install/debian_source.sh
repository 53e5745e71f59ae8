#!/usr/bin/env bash
# debian_source.sh FOLDER PACKAGE...: unpacks source packages of Debian 12 in FOLDER, from where apt gets its packages. The machine
# itself stays as it is. Ends with 1 where they cannot be had.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
mirror=$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' 'Created-By: Packages' | awk '$1 == "bookworm" {print $2; exit}')
[ -n "$mirror" ] || { echo "apt knows no mirror of Debian 12" >&2; exit 1; }
mkdir -p "$folder/lists"
echo "deb-src $mirror bookworm main" >"$folder/sources.list"
ask() { apt-get -q -o Dir::Etc::sourcelist="$folder/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State::lists="$folder/lists" "$@" >>"$folder/apt.log" 2>&1; }
cd "$folder"
ask update && ask source "$@" || { tail -n 3 "$folder/apt.log" >&2; exit 1; }
