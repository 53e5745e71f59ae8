#pragma once

#include <vector>

#include "core/geometry/space.h"

namespace penpose::judges {

/// The least sum of |goals[i] - (x[0] columns[0][i] + x[1] columns[1][i] + ...)| with each x in 0..1, found by weighted
/// least squares again and again, each weight one over the distance before: the sum falls with every step (Weiszfeld
/// 1937). Slow and simple, so that it can be trusted.
[[nodiscard]] double least_sum_of_distances(const std::vector<std::vector<geometry::ModelVector>>& columns,
                                            const std::vector<geometry::ModelVector>& goals);

}  // namespace penpose::judges
