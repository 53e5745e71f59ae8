#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/document/drawing/target_line.h"

namespace penpose::document {
namespace {

using curve::PxPoint;
using geometry::ModelPoint;

View front() { return {{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}}; }

PxPoint seen(const ModelPoint& p, const View& view = front()) {
  return *geometry::Camera::make(view.camera, view.viewport).value().project(p);
}

std::vector<ModelPoint> reference() {
  std::vector<ModelPoint> points;
  for (int i = 0; i <= 20; ++i) points.emplace_back(-1 + 0.1 * i, 0, 0.5);
  return points;
}

/// Straight, a little above the reference.
DrawnTarget straight() {
  const std::vector<PxPoint> line{seen({-1, 0.5, 0.5}), seen({1, 0.5, 0.5})};
  return make_target(reference(), front(), line, std::vector<double>{0.5, 0.5}).value();
}

std::vector<PxPoint> stroke(const std::vector<ModelPoint>& through) {
  std::vector<PxPoint> line;
  for (std::size_t k = 0; k + 1 < through.size(); ++k) {
    for (int i = 0; i <= 10; ++i) line.push_back(seen(through[k] + (through[k + 1] - through[k]) * (0.1 * i)));
  }
  return line;
}

TEST(DrawnOver, WhatIsNotDrawnOverStaysToTheBit) {
  const DrawnTarget before = straight();
  // A high bump: by length alone it would push everything beside it along the line.
  const auto bump = stroke({{0.2, 0.5, 0.5}, {0.5, 1.5, 0.5}, {0.8, 0.5, 0.5}});
  const DrawnTarget after = drawn_over(before, reference(), front(), bump).value();
  for (std::size_t i = 0; i <= 20; ++i) {
    const double x = before.points[i].x;
    if (x < 0.18 || x > 0.82) {
      EXPECT_EQ(after.points[i], before.points[i]) << i;
    } else if (x > 0.25 && x < 0.75) {
      EXPECT_GT(after.points[i].y, before.points[i].y + 0.05) << i;
    }
  }
  EXPECT_GT(after.points[15].y, 1.3) << "the middle of the part goes to the stroke's middle";
  EXPECT_EQ(after.weights, before.weights) << "how hard was pressed stays";
  ASSERT_EQ(after.line.size(), k_line_points);
  EXPECT_LT(std::min_element(after.line.begin(), after.line.end(), [](auto a, auto b) { return a.y < b.y; })->y,
            seen({0.5, 1.4, 0.5}).y)
      << "the line that is dragged has the bump, too";
}

TEST(DrawnOver, MayBeDrawnTheOtherWay) {
  const auto bump = stroke({{0.2, 0.5, 0.5}, {0.5, 1.5, 0.5}, {0.8, 0.5, 0.5}});
  const std::vector<PxPoint> turned(bump.rbegin(), bump.rend());
  const auto one = drawn_over(straight(), reference(), front(), bump).value();
  const auto other = drawn_over(straight(), reference(), front(), turned).value();
  for (std::size_t i = 0; i <= 20; ++i) EXPECT_NEAR(geometry::distance(one.points[i], other.points[i]), 0, 1e-9) << i;
}

TEST(DrawnOver, AStrokeBesideTheLineIsLedOverToIt) {
  const auto beside = stroke({{-0.5, 0.6, 0.5}, {0.5, 0.6, 0.5}});
  const auto after = drawn_over(straight(), reference(), front(), beside).value();
  EXPECT_NEAR(after.points[10].y, straight().points[10].y + 0.1, 0.02) << "its middle is where it was drawn";
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_LT(std::abs(after.points[i + 1].y - after.points[i].y), 0.06) << "no step at " << i;
  }
}

TEST(DrawnOver, AnEndGoesWhereItIsDrawn) {
  const auto end = stroke({{0.5, 0.5, 0.5}, {1.4, 0.9, 0.5}});
  const auto after = drawn_over(straight(), reference(), front(), end).value();
  EXPECT_NEAR(geometry::distance(seen(after.points[20]), end.back()), 0, 1e-6);
  EXPECT_EQ(after.points[5], straight().points[5]);
  const auto all = drawn_over(straight(), reference(), front(), stroke({{-1.1, 0.8, 0.5}, {1.1, 0.8, 0.5}})).value();
  EXPECT_NEAR(seen(all.points[0]).x, seen({-1.1, 0.8, 0.5}).x, 1e-6);
  EXPECT_NEAR(seen(all.points[20]).x, seen({1.1, 0.8, 0.5}).x, 1e-6);
}

TEST(DrawnOver, AClosedTargetIsDrawnOverAcrossItsSeam) {
  std::vector<ModelPoint> ring;
  for (int i = 0; i <= 24; ++i) ring.emplace_back(std::cos(i * M_PI / 12), std::sin(i * M_PI / 12), 0.5);
  std::vector<PxPoint> line;
  for (const ModelPoint& p : ring) line.push_back(seen(p * 1.1));
  const DrawnTarget before = make_target(ring, front(), line, {}).value();
  // The seam lies at the right.
  const auto bulge = stroke({{0.9, -0.6, 0.5}, {1.8, 0, 0.5}, {0.9, 0.6, 0.5}});
  const auto after = drawn_over(before, ring, front(), bulge).value();
  EXPECT_GT(after.points[0].x, before.points[0].x + 0.4);
  EXPECT_GT(after.points[24].x, before.points[24].x + 0.4);
  for (std::size_t i = 5; i <= 19; ++i) EXPECT_EQ(after.points[i], before.points[i]) << i;
}

TEST(DrawnOver, RefusesWhatChangesNothing) {
  const auto refuses = [](const std::vector<PxPoint>& line) {
    return !drawn_over(straight(), reference(), front(), line).ok();
  };
  EXPECT_TRUE(refuses({{1, 1}}));
  EXPECT_TRUE(refuses({{1, 1}, {1, 1}}));
  EXPECT_TRUE(refuses(stroke({{0.33, 0.2, 0.5}, {0.33, 0.9, 0.5}}))) << "across the line";
  View behind = front();
  behind.camera.look_at = {0, 0, 12};
  EXPECT_FALSE(drawn_over(straight(), reference(), behind, stroke({{0, 0.5, 0.5}, {1, 0.5, 0.5}})).ok());
}

}  // namespace
}  // namespace penpose::document
