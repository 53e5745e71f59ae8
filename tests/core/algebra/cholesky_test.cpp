#include "core/algebra/cholesky.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/core/algebra/gram.h"

namespace penpose::algebra {
namespace {

using tests::gram;
using tests::times;

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

}  // namespace
}  // namespace penpose::algebra
