#include <gtest/gtest.h>
#include <map>

#include "core/head/cage.h"

namespace penpose::head {
namespace {

TEST(EyeLoops, EveryLoopHasTwelveVerticesAndStaysOutsideTheEyeball) {
  const Cage cage = make_cage();
  const ModelPoint center{k_eye_center[0], k_eye_center[1], k_eye_center[2]};
  std::map<double, int> counts;
  for (std::size_t v = 0; v < cage.points.size(); ++v) {
    if (cage.marks[v].x > 3.5) continue;
    ++counts[cage.marks[v].x];
    EXPECT_GT(geometry::distance(cage.points[v], center), k_eye_radius);
  }
  for (const double loop : {-2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) EXPECT_EQ(counts[loop], 12) << loop;
}

TEST(EyeLoops, UpperRimIsALash) {
  const Cage cage = make_cage();
  int lashes = 0;
  for (std::size_t q = 0; q < cage.quads.size(); ++q) {
    if (cage.kinds[q] != QuadKind::lash) continue;
    ++lashes;
    for (const std::uint32_t v : cage.quads[q]) EXPECT_GT(cage.points[v].y, k_eye_center[1] - 0.5);
  }
  EXPECT_EQ(lashes, 6);
}

}  // namespace
}  // namespace penpose::head
