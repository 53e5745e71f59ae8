#include "ui/render/picture/curve_quads.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::render {
namespace {

geometry::Camera camera() { return geometry::Camera::make({{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30}, {400, 400}).value(); }

TEST(CurveQuads, OnePieceForEachStep) {
  CurveDrawing curve;
  curve.points = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(curve_quads(curve, camera()).size(), 12U);
  curve.closed = true;
  EXPECT_EQ(curve_quads(curve, camera()).size(), 18U);
}

TEST(CurveQuads, OnePointIsADot) {
  CurveDrawing curve;
  curve.points = {{0, 0, 0}};
  const auto quads = curve_quads(curve, camera());
  ASSERT_EQ(quads.size(), 6U);
  EXPECT_NEAR(quads[0].ends[0], 200, 1e-3);
}

TEST(CurveQuads, WhatLiesBehindTheEyeSplitsTheCurve) {
  CurveDrawing curve;
  curve.points = {{-1, 0, 0}, {-0.5, 0, 0}, {0, 0, 50}, {0.5, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(curve_quads(curve, camera()).size(), 12U);
}

TEST(CurveQuads, NumbersThatAreNotFiniteAndEmptyCurvesDrawNothing) {
  CurveDrawing curve;
  EXPECT_TRUE(curve_quads(curve, camera()).empty());
  curve.points = {{NAN, 0, 0}, {0, INFINITY, 0}};
  EXPECT_TRUE(curve_quads(curve, camera()).empty());
}

TEST(CurveQuads, ADenseStrokeIsThinned) {
  CurveDrawing curve;
  for (int i = 0; i <= 1000; ++i) curve.points_px.push_back({100 + i * 0.05, 100});
  const auto pieces = curve_quads(curve, camera()).size() / 6;
  EXPECT_LE(pieces, 210U);
  EXPECT_GE(pieces, 150U);
}

}  // namespace
}  // namespace penpose::render
