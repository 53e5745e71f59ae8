// Any text behind a block of usbhid-dump: reading in pieces of any size gives the same reports.

#include <cstdint>

#include "tests/support/trace_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tests::check_in_pieces("001:002:000:STREAM  1.000000\n 01\n\n", data, size);
  return 0;
}
