#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "replay/trace/trace_source.h"

namespace penpose::cli {

/// Prints what has been gathered, once it is more than `keep` bytes, and takes it out.
void print_gathered(std::string& text, std::size_t keep);

/// Calls take(report) for every report of a trace. Errors: those of the trace.
base::Status each_report(replay::TraceSource& source, const std::function<void(const replay::TraceReport&)>& take);

/// What the end of a trace comes to: the exit status, and on the error output what was wrong with it. `reports`: how
/// many it had.
[[nodiscard]] int end_of_trace(const replay::TraceSource& source, const std::string& path, std::uint64_t reports);

/// Says on the error output which of several tablets what was printed was read as (decode::Recognition::guess).
void warn_of_guesses(const std::set<std::string>& guesses, const std::string& path);
/// A guess as a value of JSON; null where it is empty.
void append_json_guess(std::string& out, const std::string& guess);

}  // namespace penpose::cli
