#include <gtest/gtest.h>
#include <map>

#include "core/head/cage.h"

namespace penpose::head {
namespace {

TEST(MouthLoops, UpperLipLiesAboveLowerLipOutsideTheSeam) {
  const Cage cage = make_cage();
  std::map<double, int> counts;
  for (std::size_t v = 0; v < cage.points.size(); ++v) {
    const LoopMark& mark = cage.marks[v];
    if (mark.y > 3.5 || mark.y < -2.5) continue;
    ++counts[mark.y];
    if (mark.y == 0 || mark.z == 0) continue;
    EXPECT_GT((cage.points[v].y - mouth_line(cage.points[v].x)) * mark.z, 0);
  }
  for (const double loop : {-2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) EXPECT_EQ(counts[loop], 11) << loop;
}

TEST(MouthLoops, CornersTurnUp) { EXPECT_GT(mouth_line(2.3), mouth_line(0)); }

}  // namespace
}  // namespace penpose::head
