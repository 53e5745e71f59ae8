#pragma once

#include <span>
#include <vector>

namespace penpose::animation {

/// The quantile of the numbers at a share, interpolated linearly; 0 for no numbers.
[[nodiscard]] double quantile(std::span<const double> numbers, double share);

/// A robust standard deviation: 1.4826 times the median distance from the median.
[[nodiscard]] double spread(std::span<const double> numbers);

/// The median of each number's neighbours, `half` to each side, fewer at the ends.
[[nodiscard]] std::vector<double> running_median(std::span<const double> numbers, std::size_t half);

}  // namespace penpose::animation
