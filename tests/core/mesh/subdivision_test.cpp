#include "core/mesh/subdivision.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace penpose::mesh {
namespace {

QuadMesh cube() {
  QuadMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  mesh.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

TEST(Subdivision, CubeHasTheVerticesOfCatmullAndClark) {
  const auto finer = catmull_clark(cube());
  ASSERT_TRUE(finer);
  ASSERT_EQ(finer->positions.size(), 8U + 12U + 6U);
  EXPECT_EQ(finer->quads.size(), 24U);
  // A corner of valence 3: (F + 2 E + 0 V) / 3 with F and E the means of face centres and edge middles: 5/9.
  EXPECT_NEAR(finer->positions[7].x, 5.0 / 9, 1e-15);
  // Edge points (0, 3/4, 3/4) and face points (0, 0, 1).
  const auto has = [&](const geometry::ModelPoint& p) {
    return std::any_of(finer->positions.begin(), finer->positions.end(),
                       [&](const auto& q) { return geometry::distance(p, q) < 1e-15; });
  };
  EXPECT_TRUE(has({0, 0.75, 0.75}));
  EXPECT_TRUE(has({0, 0, 1}));
}

TEST(Subdivision, ParentsAndOrderOfCorners) {
  const QuadMesh coarse = cube();
  const auto finer = catmull_clark(coarse);
  ASSERT_TRUE(finer);
  std::vector<int> children(coarse.quads.size(), 0);
  for (std::size_t q = 0; q < finer->quads.size(); ++q) {
    const Quad& parent = coarse.quads[finer->parents[q]];
    ++children[finer->parents[q]];
    EXPECT_NE(std::find(parent.begin(), parent.end(), finer->quads[q][2]), parent.end());
    geometry::ModelPoint middle{0};
    for (const std::uint32_t v : parent) middle += coarse.positions[v] * 0.25;
    EXPECT_LT(geometry::distance(middle, finer->positions[finer->quads[q][0]]), 1e-15);
  }
  for (const int count : children) EXPECT_EQ(count, 4);
}

TEST(Subdivision, BordersFollowTheBorderAlone) {
  QuadMesh strip;
  for (int i = 0; i < 3; ++i) {
    strip.positions.emplace_back(i, 0, 0);
    strip.positions.emplace_back(i, 1, 5.0 * i);
  }
  strip.quads = {{0, 2, 3, 1}, {2, 4, 5, 3}};
  const auto finer = catmull_clark(strip);
  ASSERT_TRUE(finer);
  EXPECT_EQ(finer->positions[2], geometry::ModelPoint(1, 0, 0));
}

TEST(Subdivision, EqualQuadsGiveEqualNumbering) {
  QuadMesh moved = cube();
  for (auto& p : moved.positions) p = p * 3.0 + geometry::ModelPoint{1, 2, 3};
  const auto a = catmull_clark(cube());
  const auto b = catmull_clark(moved);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->quads, b->quads);
  for (std::size_t v = 0; v < a->positions.size(); ++v) {
    EXPECT_LT(geometry::distance(a->positions[v] * 3.0 + geometry::ModelPoint{1, 2, 3}, b->positions[v]), 1e-14);
  }
}

TEST(Subdivision, BadQuadsAreErrors) {
  QuadMesh range = cube();
  range.quads[2][1] = 8;
  auto result = catmull_clark(range);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().place, "quad 2");
  QuadMesh twice = cube();
  twice.quads.push_back(twice.quads[0]);
  EXPECT_FALSE(catmull_clark(twice));
  QuadMesh repeated = cube();
  repeated.quads[1][0] = repeated.quads[1][1];
  EXPECT_FALSE(catmull_clark(repeated));
}

}  // namespace
}  // namespace penpose::mesh
