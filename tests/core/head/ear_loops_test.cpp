#include <gtest/gtest.h>

#include "core/head/cage.h"

namespace penpose::head {
namespace {

TEST(EarLoops, EarStandsOutAndItsShellLiesWithin) {
  const Cage cage = make_cage();
  double rim = 0;
  double floor = 1e300;
  int count = 0;
  for (std::size_t v = 0; v < cage.points.size(); ++v) {
    if (cage.marks[v].z < 3) continue;
    ++count;
    rim = std::max(rim, cage.points[v].x);
    floor = std::min(floor, cage.points[v].x);
  }
  EXPECT_EQ(count, 5 * 8);
  EXPECT_GT(rim, row(4).side_x + 1);
  EXPECT_LT(floor, row(4).side_x);
}

}  // namespace
}  // namespace penpose::head
