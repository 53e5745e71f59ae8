#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "replay/recording/recording.h"
#include "replay/trace/trace_source.h"

namespace penpose::tests {

/// Gives out `bytes` in pieces of at most `piece` bytes.
inline replay::ReadBytes in_pieces(base::Bytes bytes, std::size_t piece) {
  return [rest = bytes, piece](std::span<std::uint8_t> into) mutable -> base::Result<std::size_t> {
    const std::size_t count = std::min({piece, rest.size(), into.size()});
    std::copy_n(rest.begin(), count, into.begin());
    rest = rest.subspan(count);
    return count;
  };
}

/// All reports of a trace, a line each with index, device, time and bytes; behind them the error that ended it, if one
/// did.
inline std::string reports_of(replay::ReadBytes read) {
  replay::TraceSource source(std::move(read));
  std::string all;
  for (;;) {
    const auto report = source.next();
    if (!report) return all + report.error().line();
    if (!report->has_value()) return all;
    all += std::to_string((*report)->index) + ' ' + std::to_string((*report)->device) + ' ';
    replay::append_report(all, (*report)->time_us, (*report)->bytes);
  }
}

/// Aborts unless a recording that begins with `front`, a report at once, and goes on with anything reads the same in
/// pieces of any size.
inline void check_in_pieces(const char* front, const std::uint8_t* data, std::size_t size) {
  const std::string text = front + std::string(base::as_text(base::Bytes(data, size)));
  const base::Bytes bytes = base::as_bytes(text);
  const std::size_t piece = size == 0 ? 1 : 1 + data[0] % 61;
  const std::string reports = reports_of(replay::read_recording(replay::read_from(bytes)));
  if (reports != reports_of(replay::read_recording(in_pieces(bytes, piece)))) std::abort();
  if (!reports.starts_with("0 0 E: 0.000000 ")) std::abort();
}

}  // namespace penpose::tests
