#include "core/document/view/camera_track.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::document {
namespace {

View from(geometry::ModelPoint eye, double degrees = 24) { return {{eye, {0, 0, 0}, {0, 1, 0}, degrees}, {1600, 900}}; }

double distance_of(const FramedCamera& framed) { return geometry::distance(framed.camera.eye, framed.camera.look_at); }

TEST(CameraTrack, HoldsItsViewBeforeTheFirstAndAfterTheLastKey) {
  const CameraTrack track{{{1, from({0, 0, 5})}, {2, from({5, 0, 0})}}};
  EXPECT_FALSE(camera_at({}, 1));
  EXPECT_EQ(camera_at(track, 0)->camera, track.keys[0].view.camera);
  EXPECT_EQ(camera_at(track, 1)->camera, track.keys[0].view.camera);
  EXPECT_EQ(camera_at(track, 2)->camera, track.keys[1].view.camera);
  EXPECT_EQ(camera_at(track, 9)->camera, track.keys[1].view.camera);
}

TEST(CameraTrack, TurnsAboutTheModelAndNotThroughIt) {
  const CameraTrack track{{{0, from({0, 0, 5})}, {2, from({5, 0, 0})}}};
  for (int i = 0; i <= 20; ++i) EXPECT_NEAR(distance_of(*camera_at(track, 0.1 * i)), 5, 1e-12) << i;
  const FramedCamera half = *camera_at(track, 1);
  EXPECT_NEAR(half.camera.eye.x, 5 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(half.camera.eye.z, 5 * std::sqrt(0.5), 1e-9);
  // It starts and stops without a jerk.
  const auto moved = [&](double a, double b) {
    return geometry::distance(camera_at(track, a)->camera.eye, camera_at(track, b)->camera.eye);
  };
  EXPECT_LT(moved(0, 0.1), 0.2 * moved(0.95, 1.05));
}

TEST(CameraTrack, GoesTheShorterWayRound) {
  // From 170 to 190 degrees, past the back of the model.
  const auto at = [](double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return from({5 * std::sin(angle), 0, 5 * std::cos(angle)});
  };
  const CameraTrack track{{{0, at(170)}, {1, at(190)}}};
  const FramedCamera half = *camera_at(track, 0.5);
  EXPECT_NEAR(half.camera.eye.z, -5, 1e-9);
  EXPECT_NEAR(half.camera.eye.x, 0, 1e-9);
}

TEST(CameraTrack, ACutStandsStillUpToTheNextKey) {
  const CameraTrack track{
      {{0, from({0, 0, 5}), KeyKind::stepped}, {1, from({5, 0, 0}), KeyKind::linear}, {2, from({0, 0, 5})}}};
  EXPECT_EQ(camera_at(track, 0.999)->camera, track.keys[0].view.camera);
  EXPECT_EQ(camera_at(track, 1)->camera, track.keys[1].view.camera);
  EXPECT_NEAR(camera_at(track, 1.5)->camera.eye.x, 5 * std::sqrt(0.5), 1e-9);
}

TEST(CameraTrack, ZoomingNeverGoesBeyondItsKeys) {
  const CameraTrack track{
      {{0, from({0, 0, 8})}, {1, from({0, 0, 2})}, {2, from({0, 0, 2}, 40)}, {3, from({0, 0, 6}, 20)}}};
  for (int i = 0; i <= 60; ++i) {
    const FramedCamera now = *camera_at(track, 0.05 * i);
    EXPECT_GE(distance_of(now), 2 - 1e-9) << i;
    EXPECT_LE(distance_of(now), 8 + 1e-9) << i;
    EXPECT_GE(now.camera.vertical_fov_degrees, 20 - 1e-9) << i;
    EXPECT_LE(now.camera.vertical_fov_degrees, 40 + 1e-9) << i;
  }
}

/// Where points of the model lie in a part of a picture, in shares of it.
geometry::PxPoint share(const geometry::CameraPose& camera, geometry::Viewport whole, const PartOfPicture& part,
                        const geometry::ModelPoint& point) {
  const auto px = *geometry::Camera::make(camera, whole).value().project(point);
  return {(px.x - part.from.x) / (part.to.x - part.from.x), (px.y - part.from.y) / (part.to.y - part.from.y)};
}

TEST(CameraTrack, ThePartOfAWindowThatWasKeyedIsShownAgainAsItWas) {
  const geometry::Viewport window{1440, 900};
  const PartOfPicture part{{120, 40}, {1100, 700}};
  for (const double degrees : {24.0, 1.0}) {
    const View whole{{{1, 0.5, 6}, {0.1, 0.2, 0}, {0, 1, 0}, degrees}, window};
    const View keyed = view_of_part(whole, part);
    EXPECT_EQ(keyed.viewport, (geometry::Viewport{980, 660}));
    const FramedCamera framed{keyed.camera, 980.0 / 660};
    const auto again = camera_of_whole(framed, window, part);
    for (const geometry::ModelPoint point : {geometry::ModelPoint{0.1, 0.2, 0}, {0.5, 0.7, 0}, {-0.4, 0, 0}}) {
      const auto was = share(whole.camera, window, part, point);
      const auto is = share(again, window, part, point);
      EXPECT_NEAR(is.x, was.x, degrees > 2 ? 1e-9 : 1e-2);
      EXPECT_NEAR(is.y, was.y, degrees > 2 ? 1e-9 : 1e-2);
    }
  }
}

TEST(CameraTrack, APictureOfAnotherShapeShowsAllThatWasKeyed) {
  const FramedCamera framed{{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30}, 2.0};
  const double high = 5 * std::tan(15 * 3.14159265358979323846 / 180);
  const geometry::ModelPoint corner{2 * high, high, 0};
  // As wide as it was, with room above and below.
  const PartOfPicture square{{0, 0}, {500, 500}};
  const auto tall = share(camera_of_whole(framed, {500, 500}, square), {500, 500}, square, corner);
  EXPECT_NEAR(tall.x, 1, 1e-9);
  EXPECT_NEAR(tall.y, 0.25, 1e-9);
  const PartOfPicture wide{{0, 0}, {1500, 500}};
  const auto flat = share(camera_of_whole(framed, {1500, 500}, wide), {1500, 500}, wide, corner);
  EXPECT_NEAR(flat.y, 0, 1e-9);
  EXPECT_LT(flat.x, 1);
}

}  // namespace
}  // namespace penpose::document
