#include "firmware_io/decode/hand/pen_mapping.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

/// 200 mm by 100 mm, tilt in hundredths of a degree.
PenAxes wide_tablet() {
  PenAxes axes;
  axes.x = {0, 20000, 100, true};
  axes.y = {0, 10000, 100, true};
  axes.pressure = {0, 1023, 0, true};
  axes.tilt_x = {-9000, 9000, 100, true};
  axes.tilt_y = {-9000, 9000, 100, true};
  return axes;
}

PenMapping mapping(PenMappingOptions options, const PenAxes& axes = wide_tablet()) {
  auto made = PenMapping::make(axes, std::move(options));
  EXPECT_TRUE(made.ok());
  return std::move(made).value();
}

PenSample at(std::int32_t x, std::int32_t y) {
  PenSample sample;
  sample.x = x;
  sample.y = y;
  sample.in_range = true;
  sample.tool = Tool::pen;
  return sample;
}

void expect_px(const PenMapping& map, PenSample sample, double x, double y) {
  const MappedSample mapped = map.map(sample);
  EXPECT_NEAR(mapped.x_px, x, 1e-9);
  EXPECT_NEAR(mapped.y_px, y, 1e-9);
}

TEST(PenMapping, TheWholeTabletIsTheWholePicture) {
  const PenMapping map = mapping({.width_px = 800, .height_px = 600});
  expect_px(map, at(0, 0), 0, 0);
  expect_px(map, at(20000, 10000), 800, 600);
  expect_px(map, at(5000, 5000), 200, 300);
  expect_px(map, at(-50, 20000), 0, 600);
}

TEST(PenMapping, KeepingTheAspectUsesTheMiddle) {
  // A square picture uses 100 mm of the tablet's 200.
  const PenMapping map = mapping({.width_px = 500, .height_px = 500, .keep_aspect = true});
  expect_px(map, at(5000, 0), 0, 0);
  expect_px(map, at(15000, 10000), 500, 500);
  expect_px(map, at(10000, 5000), 250, 250);
  expect_px(map, at(0, 0), 0, 0);
  // A picture wider than the tablet uses less of its height.
  const PenMapping wide = mapping({.width_px = 400, .height_px = 100, .keep_aspect = true});
  expect_px(wide, at(0, 2500), 0, 0);
  expect_px(wide, at(20000, 7500), 400, 100);
}

TEST(PenMapping, AQuarterTurnBringsTheRightEdgeToTheBottom) {
  const PenMapping map = mapping({.width_px = 300, .height_px = 600, .quarter_turns = 1});
  expect_px(map, at(0, 0), 300, 0);
  expect_px(map, at(20000, 0), 300, 600);
  expect_px(map, at(20000, 10000), 0, 600);
  const PenMapping back = mapping({.width_px = 300, .height_px = 600, .quarter_turns = -3});
  expect_px(back, at(20000, 0), 300, 600);
}

TEST(PenMapping, TurnsKeepTheAspectOfTheTurnedTablet) {
  // Turned, the tablet is 100 mm wide and 200 high, which is just the picture's shape.
  const PenMapping map = mapping({.width_px = 300, .height_px = 600, .keep_aspect = true, .quarter_turns = 3});
  expect_px(map, at(0, 0), 0, 600);
  expect_px(map, at(20000, 10000), 300, 0);
}

TEST(PenMapping, LeftHandedIsHalfATurn) {
  const PenMapping map = mapping({.width_px = 800, .height_px = 600, .left_handed = true});
  expect_px(map, at(0, 0), 800, 600);
  expect_px(map, at(20000, 0), 0, 600);
}

TEST(PenMapping, TheUsersAreaIsStretchedOverThePicture) {
  const PenMapping map = mapping({.width_px = 800, .height_px = 600, .area = TabletArea{0.5, 0.25, 1, 0.75}});
  expect_px(map, at(10000, 2500), 0, 0);
  expect_px(map, at(15000, 5000), 400, 300);
  expect_px(map, at(20000, 7500), 800, 600);
}

TEST(PenMapping, TiltIsInDegreesAndTurnsWithTheTablet) {
  PenSample sample = at(0, 0);
  sample.tilt_x = 3000;
  sample.tilt_y = -1500;
  const MappedSample upright = mapping({.width_px = 1, .height_px = 1}).map(sample);
  EXPECT_DOUBLE_EQ(upright.tilt_x_degrees, 30);
  EXPECT_DOUBLE_EQ(upright.tilt_y_degrees, -15);
  const MappedSample turned = mapping({.width_px = 1, .height_px = 1, .quarter_turns = 1}).map(sample);
  EXPECT_DOUBLE_EQ(turned.tilt_x_degrees, 15);
  EXPECT_DOUBLE_EQ(turned.tilt_y_degrees, 30);
  PenAxes axes = wide_tablet();
  axes.tilt_x = {-64, 63, 0, true};
  sample.tilt_x = 20;
  EXPECT_DOUBLE_EQ(mapping({.width_px = 1, .height_px = 1}, axes).map(sample).tilt_x_degrees, 20);
}

TEST(PenMapping, PressureGoesThroughTheCurve) {
  auto curve = PressureCurve::make({{0, 0}, {0.5, 0.1}, {1, 1}});
  ASSERT_TRUE(curve);
  const PenMapping map = mapping({.width_px = 1, .height_px = 1, .pressure = *curve});
  PenSample sample = at(0, 0);
  sample.pressure = 1023;
  EXPECT_DOUBLE_EQ(map.map(sample).pressure, 1);
  sample.pressure = 0;
  EXPECT_DOUBLE_EQ(map.map(sample).pressure, 0);
  sample.pressure = 5000;
  EXPECT_DOUBLE_EQ(map.map(sample).pressure, 1);
}

TEST(PenMapping, WithoutPressureTheTipDecides) {
  PenAxes axes = wide_tablet();
  axes.pressure = {};
  const PenMapping map = mapping({.width_px = 1, .height_px = 1}, axes);
  PenSample sample = at(0, 0);
  EXPECT_EQ(map.map(sample).pressure, 0);
  sample.tip = true;
  EXPECT_EQ(map.map(sample).pressure, 1);
}

TEST(PenMapping, RefusesWhatCannotBeMapped) {
  EXPECT_FALSE(PenMapping::make(wide_tablet(), {.width_px = 0, .height_px = 5}));
  EXPECT_FALSE(PenMapping::make({}, {.width_px = 5, .height_px = 5}));
  EXPECT_FALSE(PenMapping::make(wide_tablet(), {.width_px = 5, .height_px = 5, .area = TabletArea{0.5, 0, 0.5, 1}}));
  EXPECT_FALSE(PenMapping::make(wide_tablet(), {.width_px = 5, .height_px = 5, .area = TabletArea{0, 0, 1.5, 1}}));
}

}  // namespace
}  // namespace penpose::decode
