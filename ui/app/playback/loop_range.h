#pragma once

#include <algorithm>
#include <optional>

namespace penpose::app {

/// What is played over and over, in seconds: from one moment to another, each of which may be left open.
struct LoopRange {
  std::optional<double> from_s;
  std::optional<double> to_s;

  [[nodiscard]] bool any() const { return from_s || to_s; }
  /// An end that would lie before the beginning is open again.
  void begin_at(double time_s) {
    from_s = time_s;
    if (to_s && *to_s <= time_s) to_s.reset();
  }
  void end_at(double time_s) {
    if (time_s <= 0) return;
    to_s = time_s;
    if (from_s && *from_s >= time_s) from_s.reset();
  }
  [[nodiscard]] double begin_s() const { return from_s.value_or(0); }
  /// `last_s`: the moment of the last key.
  [[nodiscard]] double end_s(double last_s) const { return std::max(begin_s(), to_s.value_or(last_s)); }
};

}  // namespace penpose::app
