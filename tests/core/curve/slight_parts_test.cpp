#include "core/curve/slight_parts.h"

#include <gtest/gtest.h>

#include "tests/support/models/plates.h"

namespace penpose::curve {
namespace {

/// A lid below y = 0.5, lashes that stand out before its rim and hang over it by `over`, an eye behind both.
struct Look : tests::Look {
  explicit Look(double over)
      : tests::Look([&] {
          mesh::MeshSource source;
          tests::add_plate(source, -1.0, 2.0, -1.0, 0.5, 0.0);
          tests::add_plate(source, 0.2, 0.8, 0.499, 0.5 + over, 0.005);
          tests::add_plate(source, 0.2, 0.8, 0.4, 0.7, -0.05);
          return mesh::TriangleMesh::build(std::move(source)).value();
        }()) {}

  /// A line along the lashes' middle.
  ProjectedStroke draw(double y_px) {
    return sheet_curve(std::vector<PxPoint>{{370, y_px}, {630, y_px}}, 32, camera, surface()).value();
  }
  [[nodiscard]] std::uint32_t part(const mesh::MeshPoint& point) const { return sheets.component(point.triangle); }
};

TEST(SlightParts, ALineOnLashesIsMeantForTheLid) {
  Look look(0.02);
  const std::uint32_t lid = look.sheets.component(0);
  ProjectedStroke drawn = look.draw(493);
  const auto before = drawn.positions;
  ASSERT_NE(look.part(drawn.points[16]), lid);
  stand_on_body(drawn, look.surface());
  ASSERT_EQ(drawn.aside.size(), drawn.points.size());
  for (std::size_t i = 0; i < drawn.points.size(); ++i) {
    EXPECT_EQ(look.part(drawn.points[i]), lid) << "not the eye, which is as near";
    EXPECT_NEAR(drawn.positions[i].y, 0.5, 1e-6);
    EXPECT_LT(geometry::distance(drawn.positions[i] + drawn.aside[i], before[i]), 1e-9) << "seen where it was drawn";
    const auto at = mesh::position_of(drawn.points[i], look.mesh->triangles(), look.mesh->positions());
    EXPECT_LT(geometry::distance(at, drawn.positions[i]), 1e-6);
  }
}

TEST(SlightParts, WhatIsFarFromEverythingIsWhatWasDrawn) {
  Look look(0.2);
  ProjectedStroke drawn = look.draw(420);  // the tips of long feathers
  const auto points = drawn.points;
  ASSERT_NE(look.part(points[16]), look.sheets.component(0));
  stand_on_body(drawn, look.surface());
  EXPECT_EQ(drawn.points, points);
}

TEST(SlightParts, LinesOnTheBodyAreLeftAlone) {
  Look look(0.02);
  ProjectedStroke drawn = look.draw(600);
  const auto points = drawn.points;
  stand_on_body(drawn, look.surface());
  EXPECT_EQ(drawn.points, points);
  EXPECT_TRUE(drawn.aside.empty());
}

}  // namespace
}  // namespace penpose::curve
