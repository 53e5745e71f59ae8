#include "core/intent/choosing/bounded_squares.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/cholesky.h"

namespace penpose::intent {

std::vector<double> BoundedSquares::solve(std::span<const double> matrix, std::span<const double> pulls,
                                          std::span<const std::size_t> variables, const Choices& choices) {
  const std::size_t n = variables.size();
  std::vector<double> values(n, 0.0);
  factor_.assign(matrix.begin(), matrix.end());
  if (algebra::factor(factor_.data(), n, k_least_pivot)) {
    values.assign(pulls.begin(), pulls.end());
    algebra::solve_factored(factor_.data(), n, values.data());
    bool inside = true;
    for (std::size_t i = 0; i < n; ++i) {
      const double value = values[i];
      values[i] = std::clamp(value, choices.low[variables[i]], choices.high[variables[i]]);
      inside = inside && value == values[i];
    }
    if (inside) return values;
  }
  // Coordinate descent from the clamped solution.
  left_.assign(pulls.begin(), pulls.end());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) left_[k] -= values[i] * matrix[i * n + k];
  }
  constexpr int k_sweeps = 200;
  constexpr double k_still = 1e-6;
  for (int sweep = 0; sweep < k_sweeps; ++sweep) {
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!(matrix[i * n + i] > 0.0)) continue;
      const double to =
          std::clamp(values[i] + left_[i] / matrix[i * n + i], choices.low[variables[i]], choices.high[variables[i]]);
      const double change = to - values[i];
      if (change == 0.0) continue;
      values[i] = to;
      for (std::size_t k = 0; k < n; ++k) left_[k] -= change * matrix[i * n + k];
      largest = std::max(largest, std::abs(change));
    }
    if (largest < k_still) break;
  }
  return values;
}

}  // namespace penpose::intent
