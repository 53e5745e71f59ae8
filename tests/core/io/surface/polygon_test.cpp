#include "core/io/surface/polygon.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numeric>

namespace penpose::io {
namespace {

std::vector<mesh::Triangle> cut(const std::vector<mesh::ModelPoint>& points) {
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0U);
  std::vector<mesh::Triangle> triangles;
  triangulate(corners, points, triangles);
  return triangles;
}

/// Sum of the signed areas along `axis`, and whether all have the sign of the sum.
std::pair<double, bool> area(const std::vector<mesh::ModelPoint>& points, const std::vector<mesh::Triangle>& triangles,
                             int axis) {
  double sum = 0;
  bool same = true;
  for (const auto& t : triangles) {
    const double one = glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])[axis] / 2;
    same = same && one >= 0;
    sum += one;
  }
  return {sum, same};
}

TEST(Polygon, QuadIsCutAlongItsShorterDiagonal) {
  const auto triangles = cut({{0, 0, 0}, {4, 0, 0}, {5, 1, 0}, {1, 1, 0}});
  ASSERT_EQ(triangles.size(), 2U);
  for (const auto& t : triangles) {
    EXPECT_TRUE(std::count(t.begin(), t.end(), 1U) == 1 && std::count(t.begin(), t.end(), 3U) == 1);
  }
}

TEST(Polygon, ConcavePolygonsAreCoveredWithoutOverlap) {
  const std::vector<mesh::ModelPoint> arrow = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}};
  const auto [arrow_area, arrow_same] = area(arrow, cut(arrow), 2);
  EXPECT_NEAR(arrow_area, 1.5, 1e-12);
  EXPECT_TRUE(arrow_same);
  // A comb in the plane x = 7, wound the other way round.
  std::vector<mesh::ModelPoint> comb;
  for (int i = 0; i <= 8; ++i) comb.push_back({7, i, i % 2 == 0 ? 0.1 : 3.0});
  comb.push_back({7, 8, -1});
  comb.push_back({7, 0, -1});
  std::reverse(comb.begin(), comb.end());
  const auto triangles = cut(comb);
  EXPECT_EQ(triangles.size(), comb.size() - 2);
  const auto [comb_area, comb_same] = area(comb, triangles, 0);
  EXPECT_NEAR(comb_area, 8 * 1.1 + 4 * 2.9, 1e-9);
  EXPECT_TRUE(comb_same);
}

TEST(Polygon, DegenerateAndHugePolygonsStillGiveTriangles) {
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).size(), 3U);
  std::vector<mesh::ModelPoint> circle;
  for (int i = 0; i < 100000; ++i) circle.push_back({std::cos(i * 1e-5), std::sin(i * 1e-5), 0});
  EXPECT_EQ(cut(circle).size(), circle.size() - 2);
}

}  // namespace
}  // namespace penpose::io
