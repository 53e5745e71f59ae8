#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/support/random.h"

namespace penpose::tests {

/// B'B of random B with n rows: positive definite.
inline std::vector<double> gram(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> b(n * n);
  for (double& x : b) x = random(-1, 1);
  std::vector<double> a(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t r = 0; r < n; ++r) a[i * n + k] += b[r * n + i] * b[r * n + k];
    }
    a[i * n + i] += 0.1;
  }
  return a;
}
/// a x.
inline std::vector<double> times(const std::vector<double>& a, const double* x, std::size_t n) {
  std::vector<double> b(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) b[i] += a[i * n + k] * x[k];
  }
  return b;
}

}  // namespace penpose::tests
