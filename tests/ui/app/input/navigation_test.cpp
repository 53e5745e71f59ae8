#include "ui/app/input/navigation.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

const geometry::CameraPose k_front{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 24};
const geometry::Viewport k_window{1000, 800};

PxPoint seen(const geometry::CameraPose& camera, const geometry::ModelPoint& point) {
  return *geometry::Camera::make(camera, k_window)->project(point);
}

TEST(Navigation, AQuarterTurnLooksFromTheSideAtTheSameDistance) {
  const auto side = orbited(k_front, 90, 0);
  EXPECT_NEAR(side.eye.x, 4, 1e-9);
  EXPECT_NEAR(side.eye.z, 0, 1e-9);
  EXPECT_NEAR(viewpoint_of(side).yaw_degrees, 90, 1e-9);
}

TEST(Navigation, TurningUpStopsBeforeThePoleAndTheCameraStaysOne) {
  const auto above = orbited(k_front, 10, 500);
  EXPECT_NEAR(viewpoint_of(above).pitch_degrees, 89, 1e-6);
  EXPECT_TRUE(geometry::Camera::make(above, k_window).ok());
}

TEST(Navigation, WhatIsPannedFollowsThePointer) {
  const PxPoint before = seen(k_front, {0, 0, 0});
  const PxPoint after = seen(panned({k_front, k_window}, {30, -20}), {0, 0, 0});
  EXPECT_NEAR(after.x - before.x, 30, 1e-6);
  EXPECT_NEAR(after.y - before.y, -20, 1e-6);
}

TEST(Navigation, WhatIsUnderThePointerStaysThereWhileZooming) {
  const geometry::ModelPoint point{0.3, 0.2, 0};
  const PxPoint before = seen(k_front, point);
  const auto nearer = zoomed({k_front, k_window}, 0.5, before, 2);
  const PxPoint after = seen(nearer, point);
  EXPECT_NEAR(geometry::distance(before, after), 0, 1e-6);
  EXPECT_NEAR(geometry::distance(nearer.eye, nearer.look_at), 2, 1e-9);
}

TEST(Navigation, ZoomingEndsBeforeTheEyeIsInsideAndBeforeTheModelIsADot) {
  auto camera = k_front;
  for (int i = 0; i < 200; ++i) camera = zoomed({camera, k_window}, 0.5, {500, 400}, 2);
  EXPECT_GT(geometry::distance(camera.eye, camera.look_at), 0.01);
  for (int i = 0; i < 200; ++i) camera = zoomed({camera, k_window}, 2, {500, 400}, 2);
  EXPECT_LT(geometry::distance(camera.eye, camera.look_at), 100);
}

TEST(Navigation, FramingPutsTheModelIntoTheFreePartOfTheWindow) {
  const std::vector<glm::vec3> box{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}};
  const Area free{100, 50, 700, 650};
  const auto view = framed(box, k_window, free, {0, 0});
  for (const glm::vec3& p : box) {
    const PxPoint at = seen(view.camera, geometry::ModelPoint(p));
    EXPECT_TRUE(free.holds(at)) << at.x << " " << at.y;
  }
  EXPECT_NEAR(seen(view.camera, {0, 0, 0}).x, free.middle().x, 2);
  EXPECT_NEAR(seen(view.camera, {0, 0, 0}).y, free.middle().y, 2);
}

TEST(Navigation, AnotherFieldOfViewLeavesTheMiddleAsLargeAsItWas) {
  const auto flat = with_field_of_view(k_front, k_flat_degrees);
  const auto high = [](const geometry::CameraPose& camera, double depth) {
    return seen(camera, {0, 0, depth}).y - seen(camera, {0, 1, depth}).y;
  };
  EXPECT_NEAR(high(flat, 0), high(k_front, 0), 1e-6);
  // A point a quarter of a head nearer is hardly larger, and was clearly so.
  EXPECT_GT(high(k_front, 0.5), 1.1 * high(k_front, 0));
  EXPECT_LT(high(flat, 0.5), 1.01 * high(flat, 0));
  const auto back = with_field_of_view(flat, 24);
  EXPECT_NEAR(geometry::distance(back.eye, k_front.eye), 0, 1e-9);
}

TEST(Navigation, SeenFromAnotherSideWhatIsUnderAPlaceStaysThereAsNearAsItWas) {
  const auto near = zoomed({k_front, k_window}, 0.4, {620, 300}, 2);
  const PxPoint about{450, 380};
  const auto side = seen_from({near, k_window}, {90, 0}, about);
  EXPECT_NEAR(viewpoint_of(side).yaw_degrees, 90, 1e-6);
  EXPECT_NEAR(geometry::distance(side.eye, side.look_at), geometry::distance(near.eye, near.look_at), 1e-9);
  const auto again = seen_from({side, k_window}, {0, 0}, about);
  EXPECT_NEAR(geometry::distance(again.eye, near.eye), 0, 1e-9) << "and back to where one was";
}

}  // namespace
}  // namespace penpose::app
