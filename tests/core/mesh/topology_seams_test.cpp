#include <gtest/gtest.h>

#include "core/mesh/topology.h"

namespace penpose::mesh {
namespace {

/// Two triangles in two parts, with the edge from (0, 0, 0) to (0, 1, 0) in common.
MeshSource two_parts(bool same_direction) {
  MeshSource source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  source.triangles = {{0, 1, 2}, {3, 4, 5}};
  if (same_direction) source.triangles[1] = {4, 3, 5};
  source.parts = {{"a", 0, 3, 0, 1}, {"b", 3, 3, 1, 1}};
  return source;
}

TEST(Seams, PartsThatShareABorderAreOneSurface) {
  const auto weld = weld_coincident(two_parts(false));
  EXPECT_EQ(weld, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 5}));
  const auto mesh = TriangleMesh::build(two_parts(false));
  ASSERT_TRUE(mesh);
  EXPECT_EQ((*mesh)->component_count(), 1U);
}

TEST(Seams, BordersInTheSameDirectionStayApart) {
  const auto weld = weld_coincident(two_parts(true));
  EXPECT_EQ(weld, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
}

TEST(Seams, ABorderOnTheMiddleOfAnotherPartStaysApart) {
  MeshSource source = two_parts(false);
  source.positions.emplace_back(-1, 1, 0);
  source.positions.insert(source.positions.begin() + 3, ModelPoint{-0.5, 0.5, 0});
  // Part a now continues over the common edge, so that there is no border for part b to join.
  source.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
  source.parts = {{"a", 0, 4, 0, 2}, {"b", 4, 4, 2, 1}};
  const auto weld = weld_coincident(source);
  for (std::uint32_t v = 0; v < weld.size(); ++v) EXPECT_EQ(weld[v], v);
}

TEST(Seams, ThreePartsAtOneEdgeStayApart) {
  MeshSource source = two_parts(false);
  source.positions.insert(source.positions.end(), {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  source.triangles.push_back({6, 7, 8});
  source.parts.push_back({"c", 6, 3, 2, 1});
  const auto weld = weld_coincident(source);
  for (std::uint32_t v = 0; v < weld.size(); ++v) EXPECT_EQ(weld[v], v);
}

}  // namespace
}  // namespace penpose::mesh
