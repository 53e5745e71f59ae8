#include "core/geometry/bvh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace penpose::geometry {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Soup {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
glm::vec3 random_point(std::mt19937_64& random, double size) {
  return {static_cast<float>((uniform(random) - 0.5) * size), static_cast<float>((uniform(random) - 0.5) * size),
          static_cast<float>((uniform(random) - 0.5) * size)};
}

Soup random_soup(std::size_t count, double size, double triangle_size, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Soup soup;
  for (std::uint32_t t = 0; t < count; ++t) {
    const glm::vec3 center = random_point(random, size);
    for (int k = 0; k < 3; ++k) soup.positions.push_back(center + random_point(random, triangle_size));
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return soup;
}

/// A bumpy closed grid wrapped around a sphere.
Soup sphere(std::uint32_t rows, std::uint32_t columns) {
  Soup soup;
  for (std::uint32_t r = 0; r <= rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const double a = 3.14159265358979 * r / rows;
      const double around = r == 0 || r == rows ? 0.0 : std::sin(a);  // the poles close exactly
      const double b = 2 * 3.14159265358979 * c / columns;
      soup.positions.emplace_back(around * std::cos(b), std::cos(a), around * std::sin(b));
    }
  }
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t i = r * columns + c;
      const std::uint32_t j = r * columns + (c + 1) % columns;
      soup.triangles.push_back({i, j, i + columns});
      soup.triangles.push_back({j, j + columns, i + columns});
    }
  }
  return soup;
}

/// Every triangle by its own signed volumes, in long double.
std::optional<RayHit> slow_hit(const Soup& soup, const Ray& ray) {
  using Wide = long double;
  std::optional<RayHit> best;
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    std::array<std::array<Wide, 3>, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis)
        c[k][static_cast<std::size_t>(axis)] =
            static_cast<Wide>(soup.positions[soup.triangles[t][k]][axis]) - static_cast<Wide>(ray.origin[axis]);
    }
    const std::array<Wide, 3> d{ray.direction.x, ray.direction.y, ray.direction.z};
    const auto volume = [&](const auto& a, const auto& b) {
      return d[0] * (a[1] * b[2] - a[2] * b[1]) + d[1] * (a[2] * b[0] - a[0] * b[2]) +
             d[2] * (a[0] * b[1] - a[1] * b[0]);
    };
    const Wide u = volume(c[2], c[1]);
    const Wide v = volume(c[0], c[2]);
    const Wide w = volume(c[1], c[0]);
    const Wide sum = u + v + w;
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || sum == 0) continue;
    Wide distance = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      distance += (u * c[0][axis] + v * c[1][axis] + w * c[2][axis]) / sum * d[axis];
    if (!(distance > 0)) continue;
    if (!best || static_cast<double>(distance) < best->distance)
      best = RayHit{static_cast<double>(distance),
                    t,
                    {static_cast<double>(u / sum), static_cast<double>(v / sum), static_cast<double>(w / sum)}};
  }
  return best;
}

void expect_same_hits(const Soup& soup, const TriangleBvh& bvh, double size, int rays) {
  std::mt19937_64 random(3);
  int hits = 0;
  std::uint32_t hint = TriangleBvh::k_no_hint;
  for (int i = 0; i < rays; ++i) {
    const ModelPoint from = ModelPoint(random_point(random, size * 3));
    const Ray ray{from, normalized(ModelPoint(random_point(random, size)) - from)};
    const auto want = slow_hit(soup, ray);
    const auto got = bvh.nearest_hit(ray);
    ASSERT_EQ(got.has_value(), want.has_value()) << "ray " << i;
    const auto hinted = bvh.nearest_hit(ray, hint);
    ASSERT_EQ(hinted.has_value(), got.has_value());
    if (!got) continue;
    ++hits;
    EXPECT_EQ(got->triangle, want->triangle) << "ray " << i;
    EXPECT_NEAR(got->distance, want->distance, 1e-9 * size);
    EXPECT_EQ(hinted->triangle, got->triangle);
    EXPECT_EQ(hinted->distance, got->distance);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_GE(got->barycentric[k], 0.0);
    EXPECT_NEAR(got->barycentric[0] + got->barycentric[1] + got->barycentric[2], 1.0, 1e-12);
    hint = got->triangle;
  }
  EXPECT_GT(hits, rays / 20);
}

TEST(Bvh, FindsWhatASearchOfAllTrianglesFinds) {
  for (const double size : {0.01, 1.0, 5000.0}) {
    const Soup soup = random_soup(700, size, size * 0.15, 5);
    expect_same_hits(soup, TriangleBvh(soup.positions, soup.triangles), size, 600);
  }
}

TEST(Bvh, FollowsTheMeshAfterRefit) {
  Soup soup = random_soup(500, 2, 0.3, 8);
  TriangleBvh bvh(soup.positions, soup.triangles);
  std::mt19937_64 random(1);
  for (glm::vec3& p : soup.positions) p += random_point(random, 1.5);
  bvh.refit(soup.positions);
  expect_same_hits(soup, bvh, 3, 400);
}

TEST(Bvh, NoRaySlipsThroughAClosedSurface) {
  const Soup soup = sphere(40, 60);
  const TriangleBvh bvh(soup.positions, soup.triangles);
  // Straight at vertices and edge midpoints, where a careless test falls between the triangles.
  for (const Triangle& t : soup.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const ModelPoint a(soup.positions[t[k]]);
      const ModelPoint b(soup.positions[t[(k + 1) % 3]]);
      EXPECT_TRUE(bvh.nearest_hit({{0.01, -0.02, 0.03}, normalized(a - ModelPoint{0.01, -0.02, 0.03})}));
      EXPECT_TRUE(bvh.nearest_hit({{0, 0, 0}, normalized((a + b) * 0.5)}));
    }
  }
}

TEST(Bvh, RaysAlongTheAxesHit) {
  const Soup soup = sphere(20, 30);
  const TriangleBvh bvh(soup.positions, soup.triangles);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      ModelPoint from{0.013, 0.027, 0.041};
      from[axis] = -5 * sign;
      ModelVector direction{0, 0, 0};
      direction[axis] = sign;
      const auto hit = bvh.nearest_hit({from, direction});
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->distance, 4, 0.05);
    }
  }
}

TEST(Bvh, SurvivesTrianglesThatAllStandInOnePlaceOrInALongRow) {
  Soup same;
  Soup row;
  for (std::uint32_t t = 0; t < 5000; ++t) {
    const auto x = static_cast<float>(std::pow(1.005, t));
    for (const glm::vec3 corner : {glm::vec3{0, 0, 0}, glm::vec3{1, 0, 0}, glm::vec3{0, 1, 0}}) {
      same.positions.push_back(corner);
      row.positions.push_back(corner * x * 0.001F + glm::vec3{x, 0, 0});
    }
    same.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    row.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const TriangleBvh of_same(same.positions, same.triangles);
  const auto hit = of_same.nearest_hit({{0.2, 0.2, 5}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle, 0U);
  const TriangleBvh of_row(row.positions, row.triangles);
  for (const std::uint32_t t : {0U, 17U, 2500U, 4999U}) {
    const ModelPoint target(row.positions[3 * t] + (row.positions[3 * t + 1] - row.positions[3 * t]) * 0.25F +
                            (row.positions[3 * t + 2] - row.positions[3 * t]) * 0.25F);
    EXPECT_TRUE(of_row.nearest_hit({target + ModelVector{0, 0, 1}, {0, 0, -1}}));
  }
}

TEST(Bvh, AnEmptyMeshIsNeverHit) {
  const TriangleBvh bvh({}, {});
  EXPECT_FALSE(bvh.nearest_hit({{0, 0, 1}, {0, 0, -1}}));
}

}  // namespace
}  // namespace penpose::geometry
