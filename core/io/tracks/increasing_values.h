#pragma once

#include <optional>
#include <span>
#include <vector>

namespace penpose::io {

/// The longest increasing subsequence of times or numbers that should increase, and whether it can be trusted.
struct IncreasingValues {
  std::vector<bool> in_order;    ///< one a value: part of the subsequence; of equal values the first
  std::size_t known = 0;         ///< values that are present
  std::size_t out_of_order = 0;  ///< of those, how many are not part of it
  /// More than 3 of 5 values are present and in order; otherwise the list was not meant to increase, or starts again.
  [[nodiscard]] bool trusted() const { return 5 * (known - out_of_order) > 3 * in_order.size(); }
};

[[nodiscard]] IncreasingValues find_increasing(std::span<const std::optional<double>> values);

/// The typical step from one value to the next: the mean of the increases near the median increase; 0 where no value
/// increases.
[[nodiscard]] double typical_step(std::span<const std::optional<double>> values);

/// The first value that is farther from the one before (of those in order) than in any recording: by more than `least`,
/// and by more than 10 times what all values would span at their typical step. None in values that are not trusted or
/// have no typical step.
[[nodiscard]] std::optional<std::size_t> find_leap(std::span<const std::optional<double>> values,
                                                   const IncreasingValues& increasing, double least);

/// Keeps the times in order and interpolates the others between them; before the first and after the last, time goes on
/// at the mean rate. `places`: where each belongs, increasing. Precondition: two in order.
[[nodiscard]] std::vector<double> interpolate_missing(std::span<const std::optional<double>> times,
                                                      const IncreasingValues& increasing,
                                                      std::span<const double> places);

}  // namespace penpose::io
