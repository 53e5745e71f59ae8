#include "core/intent/line/view_rows.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::intent {
namespace {

using geometry::Camera;
using geometry::ModelPoint;
using geometry::ModelVector;

TEST(ViewDerivative, IsHowTheProjectionChanges) {
  tests::Random random(5);
  int seen = 0;
  for (int run = 0; run < 200; ++run) {
    const auto camera = Camera::make({random.vector(5), random.vector(1), {0, 1, 0.1}, random(5, 120)}, {800, 600});
    const ModelPoint at = random.vector(2);
    if (!camera || camera->depth(at) < 0.1) continue;
    ++seen;
    const auto d = view_derivative(*camera, at).value();
    const double step = 1e-6;
    for (int axis = 0; axis < 3; ++axis) {
      ModelVector by{0};
      by[axis] = step;
      const auto ahead = camera->project(at + by).value();
      const auto back = camera->project(at - by).value();
      const double scale = geometry::length(d.x) + geometry::length(d.y);
      EXPECT_NEAR(d.x[axis], (ahead.x - back.x) / (2 * step), 1e-5 * scale);
      EXPECT_NEAR(d.y[axis], (ahead.y - back.y) / (2 * step), 1e-5 * scale);
    }
  }
  EXPECT_GT(seen, 50);
}

TEST(ViewDerivative, TheRayLeadsAwayFromTheEyeAndMovesNothingInThePicture) {
  const Camera camera = Camera::make({{0.3, 0.2, 4}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}).value();
  const ModelPoint at{0.7, -0.5, 0.4};
  const auto d = view_derivative(camera, at).value();
  EXPECT_NEAR(glm::dot(d.x, d.ray), 0, 1e-9 * geometry::length(d.x) * geometry::length(d.ray));
  EXPECT_NEAR(glm::dot(d.y, d.ray), 0, 1e-9 * geometry::length(d.y) * geometry::length(d.ray));
  EXPECT_GT(glm::dot(d.ray, at - camera.eye()), 0);
  EXPECT_NEAR(geometry::length(d.ray) * camera.units_per_px(camera.depth(at)), 1, 1e-12);
}

TEST(ViewDerivative, NothingIsSeenBehindTheCamera) {
  const Camera camera = Camera::make({{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}).value();
  EXPECT_FALSE(view_derivative(camera, {0, 0, 4.5}));
  EXPECT_FALSE(view_derivative(camera, {1, 0, 4}));
  EXPECT_TRUE(view_derivative(camera, {0, 0, 3.9}));
}

}  // namespace
}  // namespace penpose::intent
