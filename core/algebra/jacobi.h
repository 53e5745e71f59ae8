#pragma once

#include <cmath>
#include <cstddef>

namespace penpose::algebra {

struct JacobiOptions {
  int most_sweeps = 40;
  double settled = 1e-24;  ///< ends where the squares off the diagonal come to this share of those on it; below 0 never
  bool zeroes = false;     ///< what a rotation takes away is put to 0, not left to rounding
};

/// Makes a symmetric matrix of n * n numbers diagonal by Jacobi's rotations in a fixed order (Golub and Van Loan,
/// section 8.5). `v`, n * n numbers too, becomes the eigenvectors, one a row, of length one.
inline void rotate_to_diagonal(double* a, double* v, std::size_t n, const JacobiOptions& options = {}) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) v[i * n + k] = i == k ? 1.0 : 0.0;
  }
  const auto turn = [](double& x, double& y, double c, double s) {
    const double before = x;
    x = c * before - s * y;
    y = s * before + c * y;
  };
  for (int sweep = 0; sweep < options.most_sweeps; ++sweep) {
    double off = 0;
    double diagonal = 0;
    for (std::size_t p = 0; p < n; ++p) {
      diagonal += a[p * n + p] * a[p * n + p];
      for (std::size_t q = p + 1; q < n; ++q) off += a[p * n + q] * a[p * n + q];
    }
    if (off <= options.settled * diagonal) return;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        const double apq = a[p * n + q];
        if (apq == 0.0) continue;
        const double theta = (a[q * n + q] - a[p * n + p]) / (2.0 * apq);
        const double t = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0);
        const double s = t * c;
        for (std::size_t k = 0; k < n; ++k) turn(a[k * n + p], a[k * n + q], c, s);
        for (std::size_t k = 0; k < n; ++k) turn(a[p * n + k], a[q * n + k], c, s);
        for (std::size_t k = 0; k < n; ++k) turn(v[p * n + k], v[q * n + k], c, s);
        if (options.zeroes) a[p * n + q] = a[q * n + p] = 0.0;
      }
    }
  }
}

}  // namespace penpose::algebra
