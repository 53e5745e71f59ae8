#include <gtest/gtest.h>
#include <vector>

#include "core/algebra/cholesky.h"
#include "core/algebra/elimination.h"
#include "core/algebra/jacobi.h"
#include "core/algebra/symmetric_eigen.h"
#include "tests/support/random.h"

namespace penpose::algebra {
namespace {

/// B'B of random B with n rows: positive definite.
std::vector<double> gram(std::size_t n, std::uint64_t seed) {
  tests::Random random(seed);
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
std::vector<double> times(const std::vector<double>& a, const double* x, std::size_t n) {
  std::vector<double> b(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) b[i] += a[i * n + k] * x[k];
  }
  return b;
}

TEST(Cholesky, SolvesWhatItFactored) {
  for (const std::size_t n : {1U, 2U, 6U, 17U}) {
    const auto a = gram(n, n);
    std::vector<double> wanted(n);
    for (std::size_t i = 0; i < n; ++i) wanted[i] = static_cast<double>(i) - 2.5;
    auto x = times(a, wanted.data(), n);
    auto l = a;
    ASSERT_TRUE(factor(l.data(), n));
    solve_factored(l.data(), n, x.data());
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(x[i], wanted[i], 1e-9);
  }
}

TEST(Cholesky, WhatIsNotPositiveDefiniteHasNone) {
  std::vector<double> flat = {1, 1, 1, 1};
  EXPECT_FALSE(factor(flat.data(), 2));
  std::vector<double> nearly = {1, 1, 1, 1 + 1e-9};
  auto copy = nearly;
  EXPECT_TRUE(factor(copy.data(), 2));
  EXPECT_FALSE(factor(nearly.data(), 2, 1e-6)) << "its pivot is a billionth of the diagonal";
  EXPECT_TRUE(factor(nearly.data(), 0));
}

TEST(Elimination, SolvesWithAnyOrderOfRows) {
  // 0 x + 2 y = 4, 3 x + y = 11.
  const auto x = solve(Equations<2>{{{0, 2, 4}, {3, 1, 11}}}, 1e-12);
  ASSERT_TRUE(x);
  EXPECT_NEAR((*x)[0], 3, 1e-15);
  EXPECT_NEAR((*x)[1], 2, 1e-15);
  EXPECT_FALSE(solve(Equations<2>{{{1, 2, 4}, {2, 4, 8}}}, 1e-12)) << "the rows say the same";
}

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

TEST(SymmetricEigen, TheLargestComesFirst) {
  const SymmetricEigen eigen = symmetric_eigen({2, 0, 0, 0, 5, 0, 0, 0, 3}, 3);
  EXPECT_EQ(eigen.values, (std::vector<double>{5, 3, 2}));
  EXPECT_EQ(eigen.vectors, (std::vector<double>{0, 1, 0, 0, 0, 1, 1, 0, 0}));
}

}  // namespace
}  // namespace penpose::algebra
