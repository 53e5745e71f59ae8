#include "core/geometry/closest_point.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <random>

namespace penpose::geometry {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
ModelPoint random_point(std::mt19937_64& random, double size) {
  return {(uniform(random) - 0.5) * size, (uniform(random) - 0.5) * size, (uniform(random) - 0.5) * size};
}

/// A cube of size 2 about the origin, faces outwards.
struct Cube {
  std::vector<ModelPoint> positions;
  std::vector<Triangle> triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  Cube() {
    for (int i = 0; i < 8; ++i) positions.push_back({(i & 1) * 2.0 - 1, (i & 2) - 1.0, (i & 4) / 2.0 - 1});
  }
};

TEST(ClosestPoint, FindsFacesEdgesAndCornersOfACube) {
  const Cube cube;
  const ClosestPointTree tree(cube.positions, cube.triangles);
  EXPECT_LT(distance(tree.closest({0.3, 0.2, 5}).point, {0.3, 0.2, 1}), 1e-15);
  EXPECT_NEAR(tree.closest({0.3, 0.2, 5}).normal.z, 1.0, 1e-12);
  EXPECT_LT(distance(tree.closest({3, 3, 0.5}).point, {1, 1, 0.5}), 1e-15);
  const ClosestPoint corner = tree.closest({2, 2, 2});
  EXPECT_EQ(corner.point, ModelPoint(1, 1, 1));
  EXPECT_NEAR(corner.distance, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(glm::dot(corner.normal, normalized(ModelVector{1, 1, 1})), 1.0, 1e-12);
}

TEST(ClosestPoint, TellsInsideFromOutsideEverywhere) {
  const Cube cube;
  const ClosestPointTree tree(cube.positions, cube.triangles);
  std::mt19937_64 random(3);
  for (int i = 0; i < 3000; ++i) {
    const ModelPoint p = random_point(random, 4);
    const bool inside = std::abs(p.x) < 1 && std::abs(p.y) < 1 && std::abs(p.z) < 1;
    const ModelVector out{std::fmax(std::abs(p.x) - 1, 0), std::fmax(std::abs(p.y) - 1, 0),
                          std::fmax(std::abs(p.z) - 1, 0)};
    const double expected =
        inside ? std::fmax(std::fmax(std::abs(p.x), std::abs(p.y)), std::abs(p.z)) - 1 : length(out);
    EXPECT_NEAR(tree.signed_distance(p), expected, 1e-12);
  }
}

TEST(ClosestPoint, AgreesWithLookingAtEveryTriangle) {
  std::mt19937_64 random(11);
  std::vector<ModelPoint> positions;
  std::vector<Triangle> triangles;
  for (std::uint32_t t = 0; t < 500; ++t) {
    const ModelPoint center = random_point(random, 10);
    for (int k = 0; k < 3; ++k) positions.push_back(center + random_point(random, 1.5));
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  triangles.push_back({0, 0, 0});  // no area
  const ClosestPointTree tree(positions, triangles);
  std::vector<ClosestPointTree> single;
  for (const Triangle& triangle : triangles) single.emplace_back(positions, std::span(&triangle, 1));
  for (int i = 0; i < 300; ++i) {
    const ModelPoint p = random_point(random, 14);
    double nearest = 1e300;
    for (const ClosestPointTree& one : single) nearest = std::fmin(nearest, one.closest(p).distance);
    const ClosestPoint found = tree.closest(p);
    EXPECT_EQ(found.distance, nearest);
    const auto& [a, b, c] = triangles[found.triangle];
    const ModelPoint at =
        positions[a] * found.barycentric[0] + positions[b] * found.barycentric[1] + positions[c] * found.barycentric[2];
    EXPECT_LT(distance(at, found.point), 1e-12);
  }
}

}  // namespace
}  // namespace penpose::geometry
