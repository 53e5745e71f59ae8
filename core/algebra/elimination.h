#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace penpose::algebra {

/// A x = b of n unknowns: n coefficients a row and, behind them, the right side.
template <std::size_t n>
using Equations = std::array<std::array<double, n + 1>, n>;

/// Gauss's elimination with the largest pivot of each column (Golub and Van Loan, section 3.4). Nothing where none is
/// above `least_pivot`.
template <std::size_t n>
[[nodiscard]] std::optional<std::array<double, n>> solve(Equations<n> a, double least_pivot) {
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t r = k + 1; r < n; ++r) {
      if (std::abs(a[r][k]) > std::abs(a[best][k])) best = r;
    }
    if (!(std::abs(a[best][k]) > least_pivot)) return std::nullopt;
    std::swap(a[k], a[best]);
    for (std::size_t r = k + 1; r < n; ++r) {
      const double share = a[r][k] / a[k][k];
      for (std::size_t c = k; c <= n; ++c) a[r][c] -= share * a[k][c];
    }
  }
  std::array<double, n> x{};
  for (std::size_t k = n; k-- > 0;) {
    double sum = a[k][n];
    for (std::size_t c = k + 1; c < n; ++c) sum -= a[k][c] * x[c];
    x[k] = sum / a[k][k];
  }
  return x;
}

}  // namespace penpose::algebra
