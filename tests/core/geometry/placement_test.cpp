#include "core/geometry/placement.h"

#include <gtest/gtest.h>

namespace penpose::geometry {
namespace {

constexpr Placement k_first{{1, 2, 3}, 30, 2};
constexpr Placement k_then{{-4, 0.5, 1}, -75, 0.25};

void expect_near(const ModelPoint& a, const ModelPoint& b) { EXPECT_LT(distance(a, b), 1e-12); }

TEST(Placement, ScalesThenTurnsThenMoves) {
  expect_near(placed({{1, 0, 0}, 90, 2}, {0, 1, 3}), {7, 2, 0});
  expect_near(turned({{1, 0, 0}, 90, 2}, {0, 0, 1}), {1, 0, 0});
}

TEST(Placement, JoinsAndGoesBack) {
  const ModelPoint point{0.3, -7, 2};
  expect_near(placed(joined(k_first, k_then), point), placed(k_then, placed(k_first, point)));
  expect_near(placed(inverse(k_first), placed(k_first, point)), point);
  expect_near(placed(joined(k_first, inverse(k_first)), point), point);
}

TEST(Placement, APlacedCameraSeesThePlacedModelAsBefore) {
  const CameraPose pose{{2, 1, 9}, {0.5, 0, 0}, {0, 1, 0}, 24};
  const auto camera = Camera::make(pose, {800, 600});
  const auto moved = Camera::make(placed(k_first, pose), {800, 600});
  ASSERT_TRUE(camera.ok() && moved.ok());
  const ModelPoint point{0.4, 0.7, -1};
  const auto before = camera->project(point);
  const auto after = moved->project(placed(k_first, point));
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(before->x, after->x, 1e-9);
  EXPECT_NEAR(before->y, after->y, 1e-9);
}

}  // namespace
}  // namespace penpose::geometry
