#pragma once

#include <algorithm>
#include <string>

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

}  // namespace penpose::tests
