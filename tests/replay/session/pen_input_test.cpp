#include "replay/session/pen_input.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "replay/session/virtual_pen.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::replay {
namespace {

using curve::PxPoint;

/// Virtual pens on a picture. Positions are px of a picture of 1000 x 500, which is 0..1000 and 0..500 of the tablet.
class PenInputTest : public testing::Test {
 protected:
  PenInputTest() {
    view.viewport = {1000, 500};
    pens.set_view(view);
    pens.connect(0, virtual_pen_identity());
    pens.connect(1, virtual_pen_identity());
  }
  std::vector<PenMoment> send(int device, VirtualPenState state) {
    time_us += 1000;
    const auto moments = pens.report(device, time_us, virtual_pen_report(state, {1000, 500}));
    return {moments.begin(), moments.end()};
  }
  void down(int device, PxPoint at, double pressure = 0.5) {
    send(device, {.position = at, .pressure = pressure, .tip = true});
  }
  void up(int device, PxPoint at) { send(device, {.position = at}); }
  void draw(int device, PxPoint from, PxPoint to) {
    down(device, from);
    down(device, to);
    up(device, to);
  }
  DrawnStroke only_stroke() {
    auto strokes = pens.take_strokes();
    EXPECT_EQ(strokes.size(), 1U);
    return strokes.empty() ? DrawnStroke{} : strokes[0];
  }
  static void expect_near(PxPoint a, PxPoint b) { EXPECT_NEAR(geometry::distance(a, b), 0, 0.05) << a.x << ' ' << a.y; }

  PenInput pens;
  document::View view;
  std::int64_t time_us = 0;
};

TEST_F(PenInputTest, AStrokeHoldsEveryReportBetweenDownAndUp) {
  EXPECT_EQ(send(0, {.position = {10, 20}}).back().kind, decode::PenEventKind::hover);
  EXPECT_EQ(pens.current(), nullptr);
  down(0, {100, 50}, 0.25);
  ASSERT_NE(pens.current(), nullptr);
  down(0, {200, 60}, 0.75);
  EXPECT_EQ(pens.current()->samples.size(), 2U);
  EXPECT_TRUE(pens.take_strokes().empty());
  up(0, {300, 70});
  EXPECT_EQ(pens.current(), nullptr);
  const auto stroke = only_stroke();
  ASSERT_EQ(stroke.samples.size(), 2U);
  expect_near(stroke.samples[0].position, {100, 50});
  expect_near(stroke.samples[1].position, {200, 60});
  EXPECT_NEAR(stroke.samples[0].pressure, 0.25, 1e-3);
  EXPECT_EQ(stroke.samples[1].time_us - stroke.samples[0].time_us, 1000);
  EXPECT_TRUE(stroke.on_canvas);
  EXPECT_FALSE(stroke.eraser);
  EXPECT_EQ(stroke.view, view);
  EXPECT_TRUE(pens.take_strokes().empty()) << "taken once";
}

TEST_F(PenInputTest, StrokesOfTwoTabletsDoNotMix) {
  down(0, {100, 50});
  down(1, {900, 450});
  down(0, {110, 50});
  down(1, {910, 450});
  up(1, {910, 450});
  down(0, {120, 50});
  up(0, {120, 50});
  const auto strokes = pens.take_strokes();
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_EQ(strokes[0].samples.size(), 2U);
  expect_near(strokes[0].samples[0].position, {900, 450});
  EXPECT_EQ(strokes[1].samples.size(), 3U);
  expect_near(strokes[1].samples[2].position, {120, 50});
}

TEST_F(PenInputTest, AStrokeBelongsToWhereItBegan) {
  pens.set_on_canvas(false);
  down(0, {10, 10});
  pens.set_on_canvas(true);
  down(0, {500, 250});
  up(0, {500, 250});
  EXPECT_FALSE(only_stroke().on_canvas) << "it began on a panel";
  down(0, {500, 250});
  pens.set_on_canvas(false);
  up(0, {10, 10});
  EXPECT_TRUE(only_stroke().on_canvas);
}

TEST_F(PenInputTest, WithAButtonHeldAStrokeDrawsNothing) {
  send(0, {.position = {10, 10}, .barrel = true});
  send(0, {.position = {10, 10}, .tip = true, .barrel = true});
  send(0, {.position = {20, 10}, .tip = true});
  up(0, {20, 10});
  EXPECT_FALSE(only_stroke().on_canvas);
  draw(0, {10, 10}, {20, 20});
  EXPECT_TRUE(only_stroke().on_canvas);
}

TEST_F(PenInputTest, ButtonsAreToldAsTheyAre) {
  const auto pressed = send(0, {.position = {10, 10}, .barrel = true});
  ASSERT_FALSE(pressed.empty());
  EXPECT_TRUE(std::any_of(pressed.begin(), pressed.end(), [](const PenMoment& moment) {
    return moment.kind == decode::PenEventKind::button_down && moment.button == 0;
  }));
  EXPECT_EQ(pressed.back().buttons, 1U);
  EXPECT_EQ(send(0, {.position = {10, 10}}).back().buttons, 0U);
}

TEST_F(PenInputTest, TheEraserEndErases) {
  send(0, {.position = {10, 10}, .tip = true, .eraser = true});
  send(0, {.position = {20, 10}, .tip = true, .eraser = true});
  send(0, {.position = {20, 10}, .eraser = true});
  EXPECT_TRUE(only_stroke().eraser);
  send(0, {.in_range = false});
  draw(0, {10, 10}, {20, 20});
  EXPECT_FALSE(only_stroke().eraser);
}

TEST_F(PenInputTest, LeavingRangeEndsAStroke) {
  down(0, {10, 10});
  down(0, {20, 10});
  send(0, {.in_range = false});
  EXPECT_EQ(only_stroke().samples.size(), 2U);
}

TEST_F(PenInputTest, UnpluggingEndsAStroke) {
  down(0, {10, 10});
  down(0, {20, 10});
  const auto moments = pens.disconnect(0, time_us);
  EXPECT_TRUE(std::any_of(moments.begin(), moments.end(),
                          [](const PenMoment& moment) { return moment.kind == decode::PenEventKind::stroke_end; }));
  EXPECT_EQ(pens.current(), nullptr);
  EXPECT_EQ(only_stroke().samples.size(), 2U);
  EXPECT_TRUE(pens.disconnect(7, time_us).empty()) << "a tablet that never was";
  pens.disconnect(0, time_us);
  EXPECT_TRUE(pens.take_strokes().empty());
}

TEST_F(PenInputTest, ATabletThatComesAgainGoesOnWithItsSetting) {
  TabletSetting turned;
  turned.left_handed = true;
  ASSERT_TRUE(pens.set_tablet(0, turned).ok());
  down(0, {10, 10});
  pens.connect(0, virtual_pen_identity());
  EXPECT_EQ(only_stroke().samples.size(), 1U) << "what was drawn is not lost";
  draw(0, {100, 50}, {200, 50});
  const auto stroke = only_stroke();
  ASSERT_EQ(stroke.samples.size(), 2U) << "and does not go on";
  expect_near(stroke.samples[0].position, {900, 450});
}

TEST_F(PenInputTest, SettingsMapTheTablet) {
  const auto place_of = [&](const TabletSetting& setting, PxPoint at) {
    EXPECT_TRUE(pens.set_tablet(0, setting).ok());
    draw(0, at, {500, 250});
    return only_stroke().samples.at(0).position;
  };
  TabletSetting area;
  area.area = {0.5, 0, 1, 1};
  expect_near(place_of(area, {750, 250}), {500, 250});
  expect_near(place_of(area, {100, 250}), {0, 250});
  TabletSetting turned;
  turned.quarter_turns = 1;
  expect_near(place_of(turned, {1000, 250}), {500, 500});
  turned.quarter_turns = 4;
  expect_near(place_of(turned, {300, 100}), {300, 100});
  TabletSetting pressed;
  pressed.pressure = {{0, 0}, {0.5, 1}, {1, 1}};
  ASSERT_TRUE(pens.set_tablet(0, pressed).ok());
  down(0, {10, 10}, 0.25);
  up(0, {10, 10});
  EXPECT_NEAR(only_stroke().samples.at(0).pressure, 0.5, 1e-3);
  draw(1, {300, 100}, {400, 100});
  expect_near(only_stroke().samples.at(0).position, {300, 100});
}

TEST_F(PenInputTest, ASettingThatCannotBeIsRefusedAndTheOldOneStays) {
  TabletSetting good;
  good.area = {0, 0, 0.5, 1};
  ASSERT_TRUE(pens.set_tablet(0, good).ok());
  for (const int device : {0, 9}) {  // one that is there and one that may come
    TabletSetting wrong;
    for (const auto& area : std::vector<std::vector<double>>{{0, 0, 1}, {0.5, 0, 0.5, 1}, {0, 0, 1, 1.5}}) {
      wrong.area = area;
      EXPECT_FALSE(pens.set_tablet(device, wrong).ok()) << device << ' ' << area.size();
    }
    wrong = {};
    wrong.pressure = {{0, 1}, {1, 0}};
    EXPECT_FALSE(pens.set_tablet(device, wrong).ok());
  }
  draw(0, {250, 250}, {400, 250});
  expect_near(only_stroke().samples.at(0).position, {500, 250});
}

TEST_F(PenInputTest, ASettingMayComeBeforeItsTablet) {
  TabletSetting setting;
  setting.area = {0.5, 0, 1, 1};
  ASSERT_TRUE(pens.set_tablet(5, setting).ok());
  EXPECT_FALSE(pens.decodes(5));
  pens.connect(5, virtual_pen_identity());
  EXPECT_TRUE(pens.decodes(5));
  draw(5, {750, 250}, {800, 250});
  expect_near(only_stroke().samples.at(0).position, {500, 250});
}

TEST_F(PenInputTest, AResizedPictureCountsFromTheNextStrokeOn) {
  down(0, {100, 50});
  document::View larger = view;
  larger.viewport = {2000, 1000};
  pens.set_view(larger);
  TabletSetting turned;
  turned.left_handed = true;
  ASSERT_TRUE(pens.set_tablet(0, turned).ok());
  down(0, {200, 50});
  up(0, {200, 50});
  const auto began_before = only_stroke();
  EXPECT_EQ(began_before.view, view);
  expect_near(began_before.samples[1].position, {200, 50});
  ASSERT_TRUE(pens.set_tablet(0, {}).ok());
  draw(0, {100, 50}, {200, 50});
  const auto after = only_stroke();
  EXPECT_EQ(after.view, larger);
  expect_near(after.samples[0].position, {200, 100});
}

TEST_F(PenInputTest, ATabletThatChangesItsFormIsMappedAnew) {
  // 28bd:0936 is in the table with 40640 by 25400; what it describes itself is 24188 by 15360.
  decode::DeviceIdentity tablet;
  tablet.vendor = 0x28bd;
  tablet.product = 0x0936;
  tablet.report_descriptor = tests::ink_descriptor();
  tablet.input_report_length = 12;
  tablet.output_report_length = 33;
  pens.connect(4, tablet);
  decode::PenSample described;
  described.in_range = true;
  described.tool = decode::Tool::pen;
  described.x = 24188 / 2;
  described.y = 15360 / 2;
  const auto moments = pens.report(4, 1000, tests::ink_pen(described));
  ASSERT_FALSE(moments.empty());
  expect_near(moments.back().position, {500, 250});
}

TEST_F(PenInputTest, WhatCannotBeDecodedGivesNothing) {
  decode::DeviceIdentity keyboard;
  keyboard.name = "keyboard";
  pens.connect(3, keyboard);
  EXPECT_FALSE(pens.decodes(3));
  EXPECT_EQ(pens.method_of(3), "");
  EXPECT_TRUE(send(3, {.tip = true}).empty());
  EXPECT_TRUE(send(8, {.tip = true}).empty()) << "a tablet that was never declared";
  const std::vector<std::uint8_t> strange{1, 2};
  EXPECT_TRUE(pens.report(0, 1, strange).empty()) << "a report that is cut off";
  EXPECT_TRUE(pens.report(0, 1, {}).empty());
  EXPECT_EQ(pens.method_of(0), "descriptor");
  EXPECT_TRUE(pens.take_strokes().empty());
}

}  // namespace
}  // namespace penpose::replay
