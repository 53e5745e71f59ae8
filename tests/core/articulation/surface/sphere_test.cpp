#include "core/articulation/surface/sphere.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace penpose::articulation {
namespace {

TEST(Sphere, APieceOfABallGivesItsMiddleAndABallThatHoldsNoPoint) {
  const ModelPoint middle{3, -2, 7};
  std::vector<ModelPoint> points;
  for (int i = 0; i < 10; ++i) {
    for (int k = 0; k < 10; ++k) {
      const double a = 0.1 * i;
      const double b = 0.1 * k;
      points.push_back(middle + ModelVector{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)} * 0.012);
    }
  }
  const auto ball = Sphere::fitted(points);
  ASSERT_TRUE(ball.has_value());
  EXPECT_NEAR(geometry::distance(ball->center, middle), 0, 1e-6);
  EXPECT_LT(ball->radius, 0.012);
  EXPECT_GT(ball->radius, 0.011);
}

TEST(Sphere, APlaneAndTooFewPointsHaveNone) {
  std::vector<ModelPoint> flat;
  for (int i = 0; i < 25; ++i) flat.emplace_back(i % 5, i / 5, 2.0);
  EXPECT_FALSE(Sphere::fitted(flat).has_value());
  EXPECT_FALSE(Sphere::fitted(std::vector<ModelPoint>(3, ModelPoint{1, 2, 3})).has_value());
  EXPECT_FALSE(Sphere::fitted(std::vector<ModelPoint>(9, ModelPoint{1, 2, 3})).has_value());
}

}  // namespace
}  // namespace penpose::articulation
