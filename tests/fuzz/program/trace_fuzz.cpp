// Any bytes as a trace: written out again line by line they must be the same bytes, and reading in pieces of any size
// must give the same reports.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "replay/trace/trace_source.h"

using namespace penpose;

namespace {

/// Gives out `bytes` in small pieces.
replay::ReadBytes in_pieces(base::Bytes bytes, std::size_t piece) {
  return [rest = bytes, piece](std::span<std::uint8_t> into) mutable -> base::Result<std::size_t> {
    const std::size_t count = std::min({piece, rest.size(), into.size()});
    std::copy_n(rest.begin(), count, into.begin());
    rest = rest.subspan(count);
    return count;
  };
}

std::string reports_of(replay::ReadBytes read) {
  replay::TraceSource source(std::move(read));
  std::string all;
  for (;;) {
    const auto report = source.next();
    if (!report) std::abort();
    if (!report->has_value()) break;
    all += std::to_string((*report)->index) + ' ' + std::to_string((*report)->device) + ' ';
    replay::append_report(all, (*report)->time_us, (*report)->bytes);
  }
  return all;
}

}  // namespace

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
  if (reports_of(replay::read_from(bytes)) != reports_of(in_pieces(bytes, piece))) std::abort();
  return 0;
}
