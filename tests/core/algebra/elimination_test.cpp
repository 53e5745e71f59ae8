#include "core/algebra/elimination.h"

#include <gtest/gtest.h>
#include <vector>

namespace penpose::algebra {
namespace {

TEST(Elimination, SolvesWithAnyOrderOfRows) {
  // 0 x + 2 y = 4, 3 x + y = 11.
  const auto x = solve(Equations<2>{{{0, 2, 4}, {3, 1, 11}}}, 1e-12);
  ASSERT_TRUE(x);
  EXPECT_NEAR((*x)[0], 3, 1e-15);
  EXPECT_NEAR((*x)[1], 2, 1e-15);
  EXPECT_FALSE(solve(Equations<2>{{{1, 2, 4}, {2, 4, 8}}}, 1e-12)) << "the rows say the same";
}

}  // namespace
}  // namespace penpose::algebra
