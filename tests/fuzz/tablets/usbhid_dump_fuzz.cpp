// Any text behind a block of usbhid-dump: reading in pieces of any size gives the same reports.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "replay/recording/recording.h"
#include "tests/support/trace_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text =
      "001:002:000:STREAM  1.000000\n 01\n\n" + std::string(base::as_text(base::Bytes(data, size)));
  const base::Bytes bytes = base::as_bytes(text);
  const std::size_t piece = size == 0 ? 1 : 1 + data[0] % 61;
  const std::string reports = tests::reports_of(replay::read_recording(replay::read_from(bytes)));
  if (reports != tests::reports_of(replay::read_recording(tests::in_pieces(bytes, piece)))) std::abort();
  if (!reports.starts_with("0 0 E: 0.000000 ")) std::abort();
  return 0;
}
