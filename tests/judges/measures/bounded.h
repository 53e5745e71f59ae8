#pragma once

#include <vector>

namespace penpose::judges {

/// Damped least squares within 0..1: minimises |A x - b|^2 + damp^2 |x|^2 by descending one coordinate after the other.
/// `columns`: those of A, each as long as `b`. Converges for damp > 0.
[[nodiscard]] std::vector<double> bounded_least_squares(const std::vector<std::vector<double>>& columns,
                                                        const std::vector<double>& b, double damp);

}  // namespace penpose::judges
