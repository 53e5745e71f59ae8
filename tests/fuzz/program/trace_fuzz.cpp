// Any bytes as a trace: written out again line by line they must be the same bytes, and reading in pieces of any size
// must give the same reports.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "tests/support/trace_reports.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes(data, size);
  replay::TraceReader reader(replay::read_from(bytes));
  std::string again;
  for (;;) {
    const auto line = reader.next();
    if (!line) std::abort();
    if (!line->has_value()) break;
    replay::append_line(again, **line);
  }
  if (again != base::as_text(bytes)) std::abort();
  const std::size_t piece = size == 0 ? 1 : 1 + data[0] % 61;
  if (tests::reports_of(replay::read_from(bytes)) != tests::reports_of(tests::in_pieces(bytes, piece))) std::abort();
  return 0;
}
