#include "firmware_io/decode/hand/pressure_curve.h"

#include <gtest/gtest.h>
#include <limits>

namespace penpose::decode {
namespace {

TEST(PressureCurve, WithoutPointsLeavesPressureAsItIs) {
  const PressureCurve straight;
  EXPECT_EQ(straight(0.25), 0.25);
  EXPECT_EQ(straight(-1), 0);
  EXPECT_EQ(straight(2), 1);
  EXPECT_EQ(straight(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(PressureCurve, InterpolatesBetweenItsPoints) {
  const auto curve = PressureCurve::make({{0, 0.1}, {0.5, 0.2}, {1, 1}});
  ASSERT_TRUE(curve);
  EXPECT_DOUBLE_EQ((*curve)(0), 0.1);
  EXPECT_DOUBLE_EQ((*curve)(0.25), 0.15);
  EXPECT_DOUBLE_EQ((*curve)(0.5), 0.2);
  EXPECT_DOUBLE_EQ((*curve)(0.75), 0.6);
  EXPECT_DOUBLE_EQ((*curve)(1), 1);
}

TEST(PressureCurve, NamesThePointThatIsWrong) {
  const auto place = [](std::vector<PressureCurve::Point> points) {
    const auto curve = PressureCurve::make(std::move(points));
    return curve ? std::string("none") : curve.error().place;
  };
  EXPECT_EQ(place({{0, 0}}), "point 0");
  EXPECT_EQ(place({{0, 0}, {0.5, 1.5}, {1, 1}}), "point 1");
  EXPECT_EQ(place({{0, 0}, {0.5, 0.5}, {0.5, 0.6}, {1, 1}}), "point 2");
  EXPECT_EQ(place({{0, 0.5}, {1, 0.4}}), "point 1");
  EXPECT_EQ(place({{0.1, 0}, {1, 1}}), "point 0");
  EXPECT_EQ(place({{0, 0}, {0.9, 1}}), "point 1");
  EXPECT_EQ(place({{0, std::numeric_limits<double>::quiet_NaN()}, {1, 1}}), "point 0");
}

}  // namespace
}  // namespace penpose::decode
