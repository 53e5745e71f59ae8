#pragma once

#include <cstdint>
#include <string>

#include "replay/trace/trace_source.h"

namespace penpose::cli {

/// Prints what has been gathered, once it is more than `keep` bytes, and takes it out.
void print_gathered(std::string& text, std::size_t keep);

/// What the end of a trace comes to: the exit status, and on the error output what was wrong with it. `reports`: how
/// many it had.
[[nodiscard]] int end_of_trace(const replay::TraceSource& source, const std::string& path, std::uint64_t reports);

/// Hands each report of the trace to `take`. Errors of the source.
template <typename Take>
base::Status for_each_report(replay::TraceSource& source, Take take) {
  for (;;) {
    const auto report = source.next();
    if (!report) return report.error();
    if (!report->has_value()) return base::Done{};
    take(**report);
  }
}

}  // namespace penpose::cli
