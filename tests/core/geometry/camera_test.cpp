#include "core/geometry/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "core/base/math.h"

namespace penpose::geometry {
namespace {

CameraPose looking_down_z(double fov_degrees = 90) { return {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, fov_degrees}; }

TEST(Camera, PutsPointsWhereAPinholeDoes) {
  // 90 degrees: at depth 10 the picture spans 20 units over its 1000 px of height, 40 over its 2000 px of width.
  const Camera camera = Camera::make(looking_down_z(), {2000, 1000}).value();
  const auto px = [&](const ModelPoint& p) { return camera.project(p).value(); };
  EXPECT_NEAR(px({0, 0, 0}).x, 1000, 1e-9);
  EXPECT_NEAR(px({0, 0, 0}).y, 500, 1e-9);
  EXPECT_NEAR(px({10, 0, 0}).x, 1500, 1e-9);
  EXPECT_NEAR(px({0, 10, 0}).y, 0, 1e-9);
  EXPECT_NEAR(px({0, -4, 2}).y, 500 + 250, 1e-9);
  EXPECT_NEAR(camera.units_per_px(10), 0.02, 1e-15);
  EXPECT_NEAR(camera.depth({3, 4, 2}), 8, 1e-12);
}

TEST(Camera, ShowsNothingBehindTheEye) {
  const Camera camera = Camera::make(looking_down_z(), {100, 100}).value();
  EXPECT_FALSE(camera.project({0, 0, 10}));
  EXPECT_FALSE(camera.project({1, 1, 12}));
  EXPECT_TRUE(camera.project({0, 0, 9.999}));
  EXPECT_LT(camera.depth({0, 0, 11}), 0);
}

TEST(Camera, HasAnUprightFrame) {
  const Camera camera = Camera::make({{3, 4, 5}, {-1, 0, 2}, {0.1, 1, 0.2}, 40}, {640, 480}).value();
  EXPECT_NEAR(length(camera.right()), 1, 1e-12);
  EXPECT_NEAR(length(camera.up()), 1, 1e-12);
  EXPECT_NEAR(glm::dot(camera.right(), camera.up()), 0, 1e-12);
  EXPECT_NEAR(glm::dot(camera.right(), camera.forward()), 0, 1e-12);
  EXPECT_NEAR(distance(glm::cross(camera.right(), camera.up()), -camera.forward()), 0, 1e-12);
  EXPECT_GT(glm::dot(camera.up(), camera.pose().up), 0);
}

TEST(Camera, ARayGoesThroughThePointThatItsPxShows) {
  std::mt19937_64 random(2);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 * 2 - 1; };
  for (int i = 0; i < 500; ++i) {
    const CameraPose pose{{10 * uniform(), 10 * uniform(), 10 * uniform()},
                          {uniform(), uniform(), uniform()},
                          {uniform(), uniform(), uniform()},
                          60 + 50 * uniform()};
    const auto camera = Camera::make(pose, {1280, 720});
    if (!camera) continue;
    const PxPoint px{640 + 700 * uniform(), 360 + 400 * uniform()};
    const Ray ray = camera->ray(px);
    EXPECT_NEAR(length(ray.direction), 1, 1e-12);
    EXPECT_EQ(ray.origin, pose.eye);
    const auto seen = camera->project(ray.origin + ray.direction * (0.1 + 5 * (1 + uniform())));
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->x, px.x, 1e-6);
    EXPECT_NEAR(seen->y, px.y, 1e-6);
  }
}

TEST(Camera, RefusesWhatShowsNothing) {
  const auto place = [](CameraPose pose, Viewport viewport = {100, 100}) {
    const auto camera = Camera::make(pose, viewport);
    return camera ? std::string("accepted") : camera.error().place;
  };
  const double nan = std::nan("");
  EXPECT_EQ(place(looking_down_z(), {0, 100}), "viewport");
  EXPECT_EQ(place(looking_down_z(), {100, -1}), "viewport");
  EXPECT_EQ(place(looking_down_z(0.5)), "vertical_fov_degrees");
  EXPECT_EQ(place(looking_down_z(180)), "vertical_fov_degrees");
  EXPECT_EQ(place(looking_down_z(nan)), "vertical_fov_degrees");
  EXPECT_EQ(place({{1, 1, 1}, {1, 1, 1}, {0, 1, 0}, 30}), "eye");
  EXPECT_EQ(place({{0, 0, 5}, {0, 0, 0}, {0, 0, 3}, 30}), "up");
  EXPECT_EQ(place({{0, 0, 5}, {0, 0, 0}, {0, 0, 0}, 30}), "up");
  EXPECT_EQ(place({{0, nan, 5}, {0, 0, 0}, {0, 1, 0}, 30}), "camera");
  EXPECT_EQ(place({{0, 0, 5}, {INFINITY, 0, 0}, {0, 1, 0}, 30}), "camera");
  EXPECT_EQ(place(looking_down_z(1)), "accepted");
}

TEST(FrameBox, ShowsTheWholeBoxFromEverySide) {
  for (const double size : {1e-9, 1e-3, 1.0, 180.0, 1e7}) {
    Box box;
    box.add(ModelPoint{-1, 0.5, -2} * size);
    box.add(ModelPoint{2, 4, 1} * size);
    for (const Viewport viewport : {Viewport{1000, 1000}, Viewport{1600, 400}, Viewport{300, 900}}) {
      for (const double yaw : {0.0, 35.0, 90.0, 180.0, -120.0}) {
        for (const double pitch : {0.0, 30.0, -89.0, 90.0}) {
          const Camera camera = frame_box(box, viewport, yaw, pitch);
          double nearest_edge = 1e9;
          for (int corner = 0; corner < 8; ++corner) {
            const ModelPoint p{(corner & 1) != 0 ? box.maximum.x : box.minimum.x,
                               (corner & 2) != 0 ? box.maximum.y : box.minimum.y,
                               (corner & 4) != 0 ? box.maximum.z : box.minimum.z};
            const auto px = camera.project(p);
            ASSERT_TRUE(px);
            nearest_edge = std::min({nearest_edge, px->x / viewport.width, 1 - px->x / viewport.width,
                                     px->y / viewport.height, 1 - px->y / viewport.height});
          }
          // The margin of a twelfth is kept, and no more than it is left at the tightest corner.
          EXPECT_NEAR(nearest_edge, 1.0 / 12, 1e-6) << size << " " << yaw << " " << pitch;
        }
      }
    }
  }
}

TEST(FrameBox, LooksFromTheSideAskedFor) {
  Box box;
  box.add({-1, -1, -1});
  box.add({1, 1, 1});
  const auto from = [&](double yaw, double pitch) { return -frame_box(box, {500, 500}, yaw, pitch).forward(); };
  EXPECT_NEAR(distance(from(0, 0), {0, 0, 1}), 0, 1e-12);
  EXPECT_NEAR(distance(from(90, 0), {1, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(from(0, 30).y, 0.5, 1e-12);
}

TEST(FrameBox, HasAViewOfWhateverItIsGiven) {
  Box empty;
  Box point;
  point.add({7, 8, 9});
  Box endless;
  endless.add({-INFINITY, 0, 0});
  endless.add({INFINITY, 1, 1});
  Box immense;
  immense.add({-1e308, -1e308, -1e308});
  immense.add({1e308, 1e308, 1e308});
  Box far;  // its size is lost beside its place
  far.add({1e30, 0, 0});
  far.add({std::nextafter(1e30, 2e30), 0, 0});
  Box tiny;
  tiny.add({0, 0, 0});
  tiny.add({1e-310, 0, 0});
  for (const Box& box : {empty, point, endless, immense, far, tiny}) {
    const Camera camera = frame_box(box, {0, 0}, 20, 95, 500);
    const auto center = camera.project(camera.pose().look_at);
    ASSERT_TRUE(center);
    EXPECT_TRUE(std::isfinite(center->x) && std::isfinite(center->y));
  }
  EXPECT_NEAR(distance(frame_box(point, {100, 100}, 0).pose().look_at, {7, 8, 9}), 0, 1e-12);
}

}  // namespace
}  // namespace penpose::geometry
