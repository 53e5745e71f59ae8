#include "core/mesh/mesh_point.h"

#include <gtest/gtest.h>

namespace penpose::mesh {
namespace {

TEST(MeshPoint, FollowsTheMeshWhenItDeforms) {
  const std::vector<Triangle> triangles{{0, 1, 2}, {3, 2, 1}};
  std::vector<ModelPoint> positions{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};
  const MeshPoint point{1, {0.5, 0.25, 0.25}};
  EXPECT_EQ(position_of(point, triangles, positions), (ModelPoint{3, 3, 0}));
  for (ModelPoint& p : positions) p += geometry::ModelVector{1, 2, 3};
  EXPECT_EQ(position_of(point, triangles, positions), (ModelPoint{4, 5, 3}));
  positions[3].z += 8;
  EXPECT_EQ(position_of(point, triangles, positions), (ModelPoint{4, 5, 7}));
}

TEST(MeshPoint, AtACornerItIsTheVertexItself) {
  const std::vector<Triangle> triangles{{2, 0, 1}};
  const std::vector<ModelPoint> positions{{0.1, 0.2, 0.3}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(position_of({0, {0, 1, 0}}, triangles, positions), positions[0]);
}

TEST(MeshPoint, OfAVertexIsThatVertex) {
  const std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 3}};
  const std::vector<ModelPoint> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 5}};
  for (std::uint32_t v = 0; v < 4; ++v)
    EXPECT_EQ(position_of(mesh_point_at(v, triangles).value(), triangles, positions), positions[v]);
  EXPECT_FALSE(mesh_point_at(9, triangles));
}

}  // namespace
}  // namespace penpose::mesh
