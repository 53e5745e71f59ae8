#include "core/head/parts.h"

#include <gtest/gtest.h>
#include <set>
#include <utility>

namespace penpose::head {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Edges that only one triangle uses.
std::size_t border(const Surface& surface) {
  std::set<Edge> edges;
  for (const mesh::Triangle& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(edges.insert({t[k], t[(k + 1) % 3]}).second);
  }
  std::size_t open = 0;
  for (const Edge& e : edges) open += edges.count({e.second, e.first}) == 0 ? 1U : 0U;
  return open;
}

TEST(HeadParts, EyeballIsAClosedTrueSphere) {
  const Surface ball = make_eye_cap(1, 0, 180, 24, 36);
  EXPECT_EQ(border(ball), 0U);
  const ModelPoint center{k_eye_center[0], k_eye_center[1], k_eye_center[2]};
  double volume = 0;
  for (const ModelPoint& p : ball.points) EXPECT_NEAR(geometry::distance(p, center), k_eye_radius, 1e-13);
  for (const mesh::Triangle& t : ball.triangles) {
    const ModelVector a = ball.points[t[0]] - center;
    const ModelVector b = ball.points[t[1]] - center;
    const ModelVector c = ball.points[t[2]] - center;
    const double six = a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    EXPECT_GT(six, 0) << "a triangle looks inwards";
    volume += six / 6;
  }
  EXPECT_NEAR(volume / (k_eye_radius * k_eye_radius * k_eye_radius), 4.18879, 0.08);
}

TEST(HeadParts, CapsOfOneEyeShareTheirBorders) {
  const Surface pupil = make_eye_cap(1.006, 0, 13.5, 3, 36);
  const Surface iris = make_eye_cap(1.006, 13.5, 28, 3, 36);
  EXPECT_EQ(border(pupil), 36U);
  EXPECT_EQ(border(iris), 72U);
  for (std::size_t j = 0; j < 36; ++j) {
    EXPECT_EQ(pupil.points[pupil.points.size() - 36 + j], iris.points[j]);
  }
}

TEST(HeadParts, TeethAreClosedAndSymmetric) {
  const Surface teeth = make_teeth();
  EXPECT_EQ(border(teeth), 0U);
  ModelPoint sum{0};
  for (const ModelPoint& p : teeth.points) sum += p;
  EXPECT_NEAR(sum.x, 0, 1e-9);
}

}  // namespace
}  // namespace penpose::head
