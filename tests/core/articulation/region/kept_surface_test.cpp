#include "core/articulation/region/kept_surface.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

TEST(KeptSurface, WithoutASurfaceNothingChanges) {
  const KeptSurface none;
  EXPECT_FALSE(none.exists());
  EXPECT_EQ(none.keep({1, 2, 3}, {0, 0, 0}, 5.0), ModelPoint(1, 2, 3));
  EXPECT_EQ(none.lift({{0, 0, 9}, {0, 0, -1}}, 4.0, 1.0), 4.0);
}

TEST(KeptSurface, HoldsTheLevelOfABallAlongTheRayFromItsCentre) {
  const tests::Eye eye = tests::make_eye();
  const auto kept = KeptSurface::make(Sphere{eye.center, eye.radius}, *eye.canvas).value();
  const ModelPoint rest = eye.center + ModelVector{0, 0, 2};
  EXPECT_DOUBLE_EQ(kept.level(rest), 2.0);
  EXPECT_LT(
      geometry::distance(kept.keep(eye.center + ModelVector{3, 0, 0}, rest, 2.0), eye.center + ModelVector{2, 0, 0}),
      1e-15);
  // At the centre itself there is no ray: the direction at rest is kept.
  EXPECT_LT(geometry::distance(kept.keep(eye.center, rest, 2.0), rest), 1e-15);
}

TEST(KeptSurface, LiftsTargetsOntoTheLevelUnderTheirPx) {
  const tests::Eye eye = tests::make_eye();
  const auto ball = KeptSurface::make(Sphere{eye.center, eye.radius}, *eye.canvas).value();
  const auto part = KeptSurface::make(PartSurface{"ball_L"}, *eye.canvas).value();
  const auto camera = geometry::Camera::make(eye.camera, eye.viewport).value();
  for (const PxPoint px : {PxPoint{500, 500}, {560, 430}, {420, 600}}) {
    const geometry::Ray ray = camera.ray(px);
    for (const auto& [kept, level] : {std::pair{ball, eye.shell}, {part, eye.shell - eye.radius}}) {
      const double t = kept.lift(ray, 11.0, level);
      EXPECT_NEAR(kept.level(ray.origin + ray.direction * t), level, 1e-9);
      EXPECT_LT(t, 12.0);  // the near side
    }
  }
  // A ray that misses takes the place where it comes nearest.
  const geometry::Ray beside = camera.ray({990, 500});
  EXPECT_NEAR(ball.lift(beside, 11.0, eye.shell), 12.0, 0.4);
}

TEST(KeptSurface, HoldsTheSignedDistanceFromAPart) {
  const tests::Eye eye = tests::make_eye();
  const auto kept = KeptSurface::make(PartSurface{"ball_L"}, *eye.canvas).value();
  std::mt19937_64 random(5);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  for (int i = 0; i < 500; ++i) {
    const ModelVector out = geometry::normalized({uniform(), uniform(), uniform()});
    const ModelPoint moved = eye.center + out * (0.7 + uniform());
    const ModelPoint at = kept.keep(moved, {}, 0.05);
    EXPECT_NEAR(kept.level(at), 0.05, 1e-9);
  }
}

TEST(KeptSurface, KnowsItsOwnVertices) {
  const tests::Eye eye = tests::make_eye();
  const std::uint32_t skin = 0;
  const std::uint32_t ball_vertex = tests::Eye::k_rings * tests::Eye::k_columns;
  for (const Surface& surface : {Surface(Sphere{eye.center, eye.radius}), Surface(PartSurface{"ball_L"})}) {
    const auto kept = KeptSurface::make(surface, *eye.canvas).value();
    EXPECT_FALSE(kept.consists_of(skin, eye.canvas->positions()[skin]));
    EXPECT_TRUE(kept.consists_of(ball_vertex, eye.canvas->positions()[ball_vertex]));
  }
}

}  // namespace
}  // namespace penpose::articulation
