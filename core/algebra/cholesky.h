#pragma once

#include <cmath>
#include <cstddef>

namespace penpose::algebra {

// Matrices are n * n numbers by rows. Sums run in the order of the columns, so that every caller gets the same bits.
// Inline: some matrices are small and their size is known where they are made.

/// Replaces a symmetric matrix by its lower Cholesky factor, in the lower half. False where a pivot is not above
/// `least_share` of what stood on the diagonal; then the matrix is undefined.
[[nodiscard]] inline bool factor(double* m, std::size_t n, double least_share = 0.0) {
  for (std::size_t i = 0; i < n; ++i) {
    double* const row = m + i * n;
    const double least = least_share > 0.0 ? least_share * row[i] : 0.0;
    for (std::size_t c = 0; c < i; ++c) {
      const double* const above = m + c * n;
      double sum = row[c];
      for (std::size_t k = 0; k < c; ++k) sum -= row[k] * above[k];
      row[c] = sum / above[c];
    }
    double pivot = row[i];
    for (std::size_t k = 0; k < i; ++k) pivot -= row[k] * row[k];
    if (!(pivot > least)) return false;
    row[i] = std::sqrt(pivot);
  }
  return true;
}

/// L^-1 b in place, L as `factor` left it.
inline void solve_forward(const double* l, std::size_t n, double* b) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= l[i * n + k] * b[k];
    b[i] /= l[i * n + i];
  }
}

/// (L L')^-1 b in place, L as `factor` left it.
inline void solve_factored(const double* l, std::size_t n, double* b) {
  solve_forward(l, n, b);
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= l[k * n + i] * b[k];
    b[i] /= l[i * n + i];
  }
}

}  // namespace penpose::algebra
