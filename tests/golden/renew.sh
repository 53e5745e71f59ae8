#!/usr/bin/env bash
# renew.sh BUILD: after a change of behaviour (core/base/edition.h), draws the sessions that lie in the repository again: the demo
# from its strokes, the sketches of the built-in head from the demo, the tours and the tablets' sessions, then their hashes.
# The demo's sketches are compiled into the programs, so BUILD is built in between.
set -euo pipefail
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
make_session=$build/tests/tools/make_session
cmake --build "$build" --target make_session
"$make_session" demo tests/tools/strokes/sketch.json tests/tools/strokes/expressions.json ui/demo/demo.session
"$make_session" sketches ui/demo/demo.session core/character/demo_sketches.json
cmake --build "$build" --target make_session golden
for session in ui/app/tour/tours/*.session tests/data/sessions/*.session; do
  "$make_session" again "$session" "$session.new"
  mv "$session.new" "$session"
done
"$build/tests/golden/golden" --print 2 tests/data/sessions ui/demo/demo.session ui/app/tour/tours >tests/golden/hashes.txt
# The sessions of each edition stay, to be drawn by those that come.
edition=$(sed -n 's/.*k_edition = \([0-9]*\);/\1/p' core/base/edition.h)
kept=tests/data/sessions/editions/$edition
mkdir -p "$kept"
cp ui/app/tour/tours/*.session tests/data/sessions/*.session "$kept"
awk '/do begin_deformer/ && ++controls == 2 {exit} {print}' ui/demo/demo.session >"$kept/control.session"
