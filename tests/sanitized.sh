#!/usr/bin/env bash
# sanitized.sh FOLDER [WAY...]: the tests under the sanitizers, built in FOLDER and run to the end. Ways: `addresses` runs all that is
# worth it with those of addresses, leaks and undefined behaviour, `threads` what starts threads with that of races; both without a
# way. Prints a line for each and the names of what failed; ends with 1 where one finds something.
# PENPOSE_JOBS says how many compilers and tests run at a time (one a core without it); PENPOSE_ONLY, a pattern, which tests.
set -uo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- addresses threads
jobs=${PENPOSE_JOBS:-$(nproc)}
failed=0

# Left out: what runs no code of the project or builds it anew (house, install, library/installed, other machines); what judges
# files and not the program that wrote them (Blender, three.js, the validator); virtual machines; tests that give the program
# little memory or measure its memory and time, of which the sanitizers take many times as much; the corpora, which the fuzz
# targets run under the same sanitizers (tests/fuzz/run).
left_out='^(house|install|vm|blender|three|validator|other_machine|fuzz)/|^golden/aarch64|^library/(symbols|installed|document)|^ui/program/(limits|budget|hostile)'
# Threads are started by the ordered loop, by sessions on two to four threads, by tablets that are read, by pipes, by the window's
# pictures behind the model and its tablets, and by callers of the C library.
threads='^core/Parallel|^golden/[2-4]_threads|^tablets/Report|^program/(OpenFile|Files)\.|^ui/app/(Backdrop|Tablets)\.|^ui/capi/CThreads'
thread_programs='core_test golden tablets_test program_test ui_app_test ui_capi_test'

# Tests that put a library of their own first (LD_PRELOAD) are not refused for it.
export ASAN_OPTIONS=${ASAN_OPTIONS:-verify_asan_link_order=0:detect_stack_use_after_return=1:allocator_may_return_null=1}
export TSAN_OPTIONS=${TSAN_OPTIONS:-second_deadlock_stack=1}

# run WAY SANITIZERS PROGRAMS CTEST_OPTION...: builds the programs (all of the tests where none is named) and runs the tests.
run() {
  local way=$1 sanitizers=$2 programs=$3 build=$folder/$1
  shift 3
  # -O1 -g1: as fast as this gets, with lines in what is found.
  if ! cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="-O1 -g1" -DPENPOSE_SANITIZE="$sanitizers" >"$build.log" 2>&1; then
    echo "$way: FAILED to configure, see $build.log"
    failed=1
    return
  fi
  [ -n "$programs" ] || programs="$(cmake --build "$build" --target help | sed -n 's/^\([a-z_]*_test\): phony$/\1/p') penpose penpose_c golden sketch_table"
  # shellcheck disable=SC2086
  if ! cmake --build "$build" -j "$jobs" --target $programs >>"$build.log" 2>&1; then
    echo "$way: FAILED to build, see $build.log"
    failed=1
    return
  fi
  if ctest --test-dir "$build" -j "$jobs" --timeout 1800 --output-on-failure "$@" >"$build.tests.log" 2>&1; then
    echo "$way: $(sed -n 's/^100% tests passed, 0 tests failed out of \([0-9]*\)$/\1 tests/p' "$build.tests.log"), nothing found"
  else
    echo "$way: FAILED, see $build.tests.log"
    sed -n '/^The following tests FAILED:/,$p' "$build.tests.log"
    failed=1
  fi
}

for way in "$@"; do
  case $way in
    addresses) run "$way" address,undefined '' -E "$left_out" ${PENPOSE_ONLY:+-R "$PENPOSE_ONLY"} ;;
    threads) run "$way" thread "$thread_programs" -R "${PENPOSE_ONLY:-$threads}" ;;
    *) echo "no way is called $way" && exit 2 ;;
  esac
done
exit $failed
