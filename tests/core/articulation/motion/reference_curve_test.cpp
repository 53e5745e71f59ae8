#include "core/articulation/motion/reference_curve.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/curve/polyline.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

using tests::Trunk;

struct Selected {
  Region region;
  Weights weights;
};

Selected select(const Trunk& trunk, const geometry::Camera& camera) {
  Selected selected;
  selected.region = general_region(*trunk.canvas, camera, trunk.box(0.4, 3.5, 0.6)).value();
  selected.weights = specific_region(selected.region, trunk.box(0.8, 3.4, 0.5)).value();
  return selected;
}

void expect_even(std::span<const ModelPoint> curve) {
  const double length = curve::arc_length<ModelPoint>(curve);
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    EXPECT_NEAR(geometry::distance(curve[i], curve[i + 1]), length / static_cast<double>(curve.size() - 1),
                1e-2 * length);
  }
}

TEST(ReferenceCurve, InferredRunsThroughTheMiddleOfATrunk) {
  const Trunk trunk = tests::make_trunk();
  const auto camera = geometry::Camera::make(trunk.camera, trunk.viewport).value();
  const Selected selected = select(trunk, camera);
  const auto curve = infer_reference(*trunk.canvas, selected.region, selected.weights.specific, 32).value();
  ASSERT_EQ(curve.size(), 32U);
  for (const ModelPoint& p : curve) {
    EXPECT_LT(std::abs(p.y), 0.05);
    EXPECT_LT(std::abs(p.z), 0.05);
  }
  EXPECT_GT(curve.back().x - curve.front().x, 1.6);  // smoothing pulls its ends in
  EXPECT_LT(curve.front().x, curve.back().x);
  expect_even(curve);
}

TEST(ReferenceCurve, InferredFollowsTheLongerExtent) {
  // The same trunk, looked at with the head on the side: it stands upright in the picture.
  Trunk trunk = tests::make_trunk();
  trunk.camera.up = {1, 0, 0};
  const auto camera = geometry::Camera::make(trunk.camera, trunk.viewport).value();
  const Selected selected = select(trunk, camera);
  const auto curve = infer_reference(*trunk.canvas, selected.region, selected.weights.specific, 16).value();
  EXPECT_GT(std::abs(curve.back().x - curve.front().x), 1.6);
}

TEST(ReferenceCurve, InferenceNeedsVertices) {
  const Trunk trunk = tests::make_trunk();
  const auto camera = geometry::Camera::make(trunk.camera, trunk.viewport).value();
  const Selected selected = select(trunk, camera);
  const std::vector<std::uint32_t> one = {selected.weights.specific.front()};
  const auto curve = infer_reference(*trunk.canvas, selected.region, one, 32);
  ASSERT_FALSE(curve.ok());
  EXPECT_NE(curve.error().remedy.find("draw"), std::string::npos);
}

TEST(ReferenceCurve, DrawnLiesOnTheVisibleSideFromEndToEnd) {
  const Trunk trunk = tests::make_trunk();
  const auto camera = geometry::Camera::make(trunk.camera, trunk.viewport).value();
  // Two corners are enough: between them the line follows the surface.
  const std::vector<PxPoint> stroke = {trunk.seen({0.8, 0, 0.2}), trunk.seen({2.8, 0, 0.2})};
  const auto curve = drawn_reference(*trunk.canvas, camera, stroke, 32).value();
  EXPECT_NEAR(curve.front().x, 0.8, 1e-6);
  EXPECT_NEAR(curve.back().x, 2.8, 1e-6);
  for (const ModelPoint& p : curve) EXPECT_NEAR(p.z, Trunk::k_radius, 0.005);
  expect_even(curve);
}

TEST(ReferenceCurve, DrawnBesideTheModelIsToldSo) {
  const Trunk trunk = tests::make_trunk();
  const auto camera = geometry::Camera::make(trunk.camera, trunk.viewport).value();
  const auto curve = drawn_reference(*trunk.canvas, camera, std::vector<PxPoint>{{1, 1}, {90, 5}}, 32);
  ASSERT_FALSE(curve.ok());
  EXPECT_NE(curve.error().what.find("does not touch"), std::string::npos);
  EXPECT_FALSE(drawn_reference(*trunk.canvas, camera, std::vector<PxPoint>{{500, 500}}, 32).ok());
}

}  // namespace
}  // namespace penpose::articulation
