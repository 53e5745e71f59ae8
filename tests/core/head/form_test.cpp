#include "core/head/form.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::head {
namespace {

TEST(Form, ProfileMeetsItsKnotsSmoothly) {
  const auto line = [](double at) { return profile({{0, 1}, {1, 3}, {2, 2}, {4, 2}}, at); };
  EXPECT_EQ(line(-1), 1);
  EXPECT_DOUBLE_EQ(line(1), 3);
  EXPECT_DOUBLE_EQ(line(2), 2);
  EXPECT_EQ(line(9), 2);
  const double before = line(1) - line(1 - 1e-6);
  const double after = line(1 + 1e-6) - line(1);
  EXPECT_NEAR(before, after, 1e-10);
}

TEST(Form, RampAndBumpAreBounded) {
  EXPECT_EQ(ramp(2, 4, 1), 0);
  EXPECT_EQ(ramp(2, 4, 5), 1);
  EXPECT_DOUBLE_EQ(ramp(2, 4, 3), 0.5);
  EXPECT_DOUBLE_EQ(ramp(4, 2, 3.5), 1 - ramp(2, 4, 3.5));
  EXPECT_EQ(bump(0), 1);
  EXPECT_EQ(bump(1.5), 0);
}

TEST(Form, RowsEndOnTheMirrorPlaneAndAtTheirSide) {
  for (int r = 0; r < k_rows; ++r) {
    const ModelPoint front = point_at_angle(row(r), 0);
    EXPECT_NEAR(front.x, 0, 1e-12);
    EXPECT_NEAR(front.z, row(r).front_z, 1e-12);
    EXPECT_NEAR(point_at_angle(row(r), 90).x, row(r).side_x, 1e-12);
    EXPECT_NEAR(point_at_angle(row(r), 180).z, row(r).back_z, 1e-9);
  }
}

TEST(Form, BareFaceRunsThroughItsRowsWithoutAStep) {
  for (int r = 2; r <= 11; ++r) {
    for (const double x : {0.0, 1.5, 3.0, 4.0}) {
      const ModelPoint p = point_at_x(row(r), x);
      EXPECT_NEAR(bare_depth(x, p.y), p.z, 1e-9);
      EXPECT_NEAR(bare_depth(x, p.y - 1e-7), bare_depth(x, p.y + 1e-7), 1e-5);
    }
  }
}

}  // namespace
}  // namespace penpose::head
