#pragma once

#include <span>
#include <vector>

namespace penpose::animation {

/// The value below which a share of the numbers lies, between neighbours in a straight line; 0 of none.
[[nodiscard]] double quantile(std::span<const double> numbers, double share);

/// How far numbers usually are from their median: 1.4826 times the median distance, which is the standard deviation of
/// a normal law and does not see a few that are far off.
[[nodiscard]] double spread(std::span<const double> numbers);

/// The median of each number's neighbours, `half` to each side, fewer at the ends.
[[nodiscard]] std::vector<double> running_median(std::span<const double> numbers, std::size_t half);

}  // namespace penpose::animation
