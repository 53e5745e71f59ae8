// Any text behind a line of OpenTabletDriver's tablet debugger: reading in pieces of any size gives the same reports.

#include <cstdint>

#include "tests/support/trace_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tests::check_in_pieces("{ 01 02 }, Delta:1.000ms\n", data, size);
  return 0;
}
