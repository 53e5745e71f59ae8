#include "core/mesh/vertex_rings.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::mesh {
namespace {

using geometry::ModelVector;

/// Twice the area vectors of all triangles at the vertices of each smoothing group.
std::vector<ModelVector> area_vectors(const TriangleMesh& mesh, std::span<const ModelPoint> positions) {
  std::vector<ModelVector> sums(mesh.vertex_count(), ModelVector{0});
  for (const Triangle& t : mesh.triangles()) {
    const ModelVector area = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const std::uint32_t v : t) sums[mesh.smoothing()[v]] += area;
  }
  return sums;
}

ModelVector by_quads(const VertexRings& rings, std::uint32_t v, std::span<const ModelPoint> positions) {
  ModelVector sum{0};
  for (const auto& [a, b, c, d] : rings.quads(v))
    sum += glm::cross(positions[c] - positions[a], positions[d] - positions[b]);
  return sum;
}

void expect_same_areas(const TriangleMesh& mesh, std::uint64_t seed) {
  const VertexRings rings(mesh);
  tests::Random random(seed);
  std::vector<ModelPoint> positions(mesh.positions().begin(), mesh.positions().end());
  for (ModelPoint& p : positions) p += random.vector(0.3);
  // Welded vertices move as one.
  for (std::uint32_t v = 0; v < positions.size(); ++v) positions[v] = positions[mesh.weld()[v]];
  const auto expected = area_vectors(mesh, positions);
  ASSERT_EQ(rings.vertex_count(), mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(rings.leader(v), mesh.smoothing()[v]);
    if (rings.leader(v) != v) {
      EXPECT_TRUE(rings.quads(v).empty());
    } else {
      EXPECT_NEAR(geometry::distance(by_quads(rings, v, positions), expected[v]), 0, 1e-12) << "vertex " << v;
    }
  }
}

TEST(VertexRings, SumTheAreasOfAClosedSurface) { expect_same_areas(*tests::ball_mesh(7, 9), 1); }

TEST(VertexRings, SumTheAreasAtABorder) { expect_same_areas(*tests::grid_mesh(5, 4), 2); }

TEST(VertexRings, SumTheAreasAcrossASeamAndAtACrease) {
  MeshSource source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  source.triangles = {{0, 1, 2}, {3, 4, 5}};
  expect_same_areas(*TriangleMesh::build(source).value(), 3);
  source.normals.assign(6, {0, 0, 1});
  source.normals[4] = {0, 1, 0};
  expect_same_areas(*TriangleMesh::build(source).value(), 4);
}

TEST(VertexRings, SumTheAreasOfSeveralFansAtOneVertex) {
  // Two cones that touch with their tips, and single triangles at the same vertex, one of them the other way round.
  MeshSource source;
  source.positions.emplace_back(0, 0, 0);
  for (int cone = 0; cone < 2; ++cone) {
    for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
      source.positions.emplace_back(x, y, cone == 0 ? 1 : -1);
  }
  for (const std::uint32_t first : {1U, 5U}) {
    for (std::uint32_t k = 0; k < 4; ++k) source.triangles.push_back({0, first + k, first + (k + 1) % 4});
  }
  for (int i = 0; i < 2; ++i) {
    const auto v = static_cast<std::uint32_t>(source.positions.size());
    source.positions.emplace_back(3, i, 0);
    source.positions.emplace_back(4, i, 0.5);
    source.triangles.push_back(i == 0 ? Triangle{v, v + 1, 0} : Triangle{0, v + 1, v});
  }
  expect_same_areas(*TriangleMesh::build(source).value(), 5);
}

TEST(VertexRings, SumTheAreasOfTrianglesThatFaceAgainstTheirNeighbours) {
  const auto grid = tests::grid_mesh(6, 6);
  MeshSource source;
  source.positions.assign(grid->positions().begin(), grid->positions().end());
  source.triangles.assign(grid->triangles().begin(), grid->triangles().end());
  tests::Random random(6);
  for (Triangle& t : source.triangles) {
    if (random.index(2) == 0) std::swap(t[0], t[1]);
  }
  expect_same_areas(*TriangleMesh::build(source).value(), 6);
}

TEST(VertexRings, TakeFewerProductsThanTriangles) {
  const auto ball = tests::ball_mesh(20, 20);
  const VertexRings rings(*ball);
  std::size_t quads = 0;
  for (std::uint32_t v = 0; v < ball->vertex_count(); ++v) quads += rings.quads(v).size();
  EXPECT_LT(quads, ball->triangle_count() * 3 / 2) << "half of one product for each corner of each triangle";
}

TEST(VertexRings, AVertexWithoutTrianglesHasNone) {
  MeshSource source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}};
  source.triangles = {{0, 1, 2}};
  const VertexRings rings(*TriangleMesh::build(source).value());
  EXPECT_TRUE(rings.quads(3).empty());
  EXPECT_FALSE(rings.quads(2).empty());
}

}  // namespace
}  // namespace penpose::mesh
