#include "core/head/cage.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <utility>

namespace penpose::head {
namespace {

TEST(Cage, HalfIsAManifoldThatIsOpenAtTheMirrorPlaneAndTheNeckOnly) {
  const Cage cage = make_cage();
  ASSERT_EQ(cage.points.size(), cage.marks.size());
  ASSERT_EQ(cage.quads.size(), cage.kinds.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const mesh::Quad& q : cage.quads) {
    for (std::size_t k = 0; k < 4; ++k) ++uses[{q[k], q[(k + 1) & 3U]}];
  }
  double neck = 1e300;
  for (const ModelPoint& p : cage.points) neck = std::min(neck, p.y);
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1) << "two quads run along an edge in the same direction";
    if (uses.count({edge.second, edge.first}) != 0) continue;
    const ModelPoint& a = cage.points[edge.first];
    const ModelPoint& b = cage.points[edge.second];
    const bool on_plane = a.x == 0 && b.x == 0;
    const bool at_neck = std::max(a.y, b.y) < neck + 1;
    EXPECT_TRUE(on_plane || at_neck) << a.x << " " << a.y << " " << a.z;
  }
}

TEST(Cage, EveryVertexIsUsedAndNoneIsBeyondThePlane) {
  const Cage cage = make_cage();
  std::vector<bool> used(cage.points.size(), false);
  for (const mesh::Quad& q : cage.quads) {
    for (const std::uint32_t v : q) used[v] = true;
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
  for (const ModelPoint& p : cage.points) EXPECT_GE(p.x, 0);
}

}  // namespace
}  // namespace penpose::head
