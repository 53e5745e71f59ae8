#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace penpose::prior {

/// Replaces a symmetric matrix of n rows by its lower Cholesky factor, in the lower half; false where it is not
/// positive definite. Sums run in the order of the rows.
[[nodiscard]] bool factor(std::vector<double>& matrix, std::size_t n);

/// Solves L L' x = b in place, L as `factor` left it.
void solve_factored(const std::vector<double>& matrix, std::size_t n, std::span<double> b);

}  // namespace penpose::prior
