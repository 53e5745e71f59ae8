#!/bin/sh
# check.sh OUT TAKE...: whether every take is done, and every file holds the state that was written down for it. Prints a line
# for each that is not so; ends with 0 when there is none.
set -eu
out=$1
shift
bad=0
for take; do
  name=$(basename "$take")
  name=${name%.*}
  if [ ! -e "$out/$name.state" ]; then
    echo "$name: not done"
    bad=1
    continue
  fi
  found=$(penpose info "$out/$name.glb" --json | sed -n 's/.*"state": *"\([0-9a-f]*\)".*/\1/p')
  if [ "$found" != "$(cat "$out/$name.state")" ]; then
    echo "$name: holds another state than was written down; remove $out/$name.state and run it again"
    bad=1
  fi
done
exit $bad
