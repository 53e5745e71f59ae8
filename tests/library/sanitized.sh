#!/usr/bin/env bash
# sanitized.sh FOLDER: the tests of the C library and of `penpose serve` under the sanitizers, built in FOLDER: a thousand handles, memory
# that runs out at every allocation, and what callers do wrong with the sanitizers of addresses, of leaks and of undefined
# behaviour; threads with a handle each with that of threads. Prints a line for each; ends with 1 where one finds something.
# PENPOSE_JOBS says how many compilers run at a time (one a core without it).
set -uo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mkdir -p "$1" && cd "$1" && pwd)
failed=0

# run WAY SANITIZERS FILTER PROGRAM...: builds the programs and runs the tests of them that FILTER names.
run() {
  local way=$1 sanitizers=$2 filter=$3 build=$folder/$1
  shift 3
  if ! { cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="-O1 -g1" -DPENPOSE_SANITIZE="$sanitizers" &&
    cmake --build "$build" --target "$@" ${PENPOSE_JOBS:+-j "$PENPOSE_JOBS"}; } >"$build.log" 2>&1; then
    echo "$way: FAILED to build, see $build.log"
    failed=1
    return
  fi
  for program in "$@"; do
    if "$build/tests/$program" --gtest_filter="$filter" >"$build.$program.log" 2>&1; then
      echo "$way, $program: $(sed -n 's/^\[  PASSED  \] //p' "$build.$program.log") nothing found"
    else
      echo "$way, $program: FAILED, see $build.$program.log"
      failed=1
    fi
  done
}

run addresses address,undefined '*' ui_capi_test ui_capi_fault_test ui_serve_test
run threads thread 'CThreads.*' ui_capi_test
exit $failed
