#include "core/algebra/jacobi.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/core/algebra/gram.h"

namespace penpose::algebra {
namespace {

using tests::gram;
using tests::times;

TEST(Jacobi, VectorsKeepTheirDirectionAndHaveLengthOne) {
  for (const bool zeroes : {false, true}) {
    for (const std::size_t n : {1U, 4U, 9U}) {
      const auto a = gram(n, 20 + n);
      auto left = a;
      std::vector<double> v(n * n);
      rotate_to_diagonal(left.data(), v.data(), n, {.most_sweeps = 30, .settled = -1, .zeroes = zeroes});
      for (std::size_t e = 0; e < n; ++e) {
        const double* const x = v.data() + e * n;
        const auto image = times(a, x, n);
        double length = 0;
        for (std::size_t i = 0; i < n; ++i) {
          length += x[i] * x[i];
          EXPECT_NEAR(image[i], left[e * n + e] * x[i], 1e-12);
        }
        EXPECT_NEAR(length, 1, 1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace penpose::algebra
