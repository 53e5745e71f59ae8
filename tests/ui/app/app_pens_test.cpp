#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

#include "replay/session/session_player.h"
#include "tests/support/app_desk.h"
#include "ui/files/trace_file.h"

// Pens, fingers and the pointer over the model.

namespace penpose::app {
namespace {

/// Tablet 1 tells of a pen that is pressed down at these places.
void draw_with_pen(Desk& desk, const std::vector<PxPoint>& line) {
  const auto viewport = desk.app->of<EditingSession>().editor().view().viewport;
  for (const PxPoint& at : line) {
    desk.now_us += 3333;
    desk.app->of<TabletEvents>().report(1, desk.now_us,
                                        replay::virtual_pen_report({at, 0.7, true, true, false, false}, viewport));
  }
}

TEST(AppPens, UnpluggingInTheMiddleOfAStrokeEndsItAndSaysSo) {
  Desk desk("unplug");
  desk.begin();
  auto identity = replay::virtual_pen_identity();
  identity.name = "Test Tablet";
  desk.app->of<TabletEvents>().arrived(1, identity);
  const auto line = desk.named_curve(any_curve(desk));
  const auto viewport = desk.app->of<EditingSession>().editor().view().viewport;
  draw_with_pen(desk, line);
  EXPECT_EQ(desk.document().curves.size(), 0U);
  desk.app->of<TabletEvents>().left(1, "Test Tablet");
  EXPECT_EQ(desk.document().curves.size(), 1U) << "what was drawn is kept";
  EXPECT_EQ(desk.app->of<Notices>().all().back().text, "Test Tablet was unplugged");
  // It comes back under its number and goes on.
  desk.app->of<TabletEvents>().arrived(1, identity);
  draw_with_pen(desk, desk.named_curve(any_curve(desk), {0, 12}));
  desk.app->of<TabletEvents>().report(1, desk.now_us,
                                      replay::virtual_pen_report({{0, 0}, 0, true, false, false, false}, viewport));
  ASSERT_EQ(desk.document().curves.size(), 1U);
  EXPECT_TRUE(desk.document().curves.front()->target.has_value());
}

TEST(AppPens, TabletsThatArePluggedInDrawOnTheNextModelToo) {
  Desk desk("reopened");
  desk.begin();
  auto gone = replay::virtual_pen_identity();
  gone.name = "Gone";
  desk.app->of<TabletEvents>().arrived(2, gone);
  desk.app->of<TabletEvents>().left(2, "Gone");
  desk.app->of<TabletEvents>().arrived(1, replay::virtual_pen_identity());
  ASSERT_TRUE(desk.app->of<Files>().open("builtin:head").ok());
  desk.frames();
  EXPECT_FALSE(desk.app->of<EditingSession>().session().pens().decodes(2)) << "what was unplugged stays so";
  const auto viewport = desk.app->of<EditingSession>().editor().view().viewport;
  const PxPoint middle{viewport.width * 0.5, viewport.height * 0.5};
  desk.now_us += 2'000'000;
  std::vector<PxPoint> line;
  for (int i = 0; i < 40; ++i) line.push_back({middle.x - 40 + 2 * i, middle.y});
  draw_with_pen(desk, line);
  EXPECT_TRUE(desk.app->of<EditingSession>().session().pens().draws(1)) << "its stroke has begun";
}

TEST(AppPens, WhileATabletsPenIsNearTheDesktopsOwnPointerIsIgnored) {
  Desk desk("near");
  desk.begin();
  desk.app->of<TabletEvents>().arrived(1, replay::virtual_pen_identity());
  const auto viewport = desk.app->of<EditingSession>().editor().view().viewport;
  desk.app->of<TabletEvents>().report(1, desk.now_us,
                                      replay::virtual_pen_report({{400, 300}, 0, true, false, false, false}, viewport));
  desk.stroke(desk.named_curve(any_curve(desk)));
  // The stroke above took longer than a pen stays near without a report; its press came while it was near.
  EXPECT_EQ(desk.document().curves.size(), 0U);
  desk.now_us += 1'000'000;
  desk.frames();
  desk.stroke(desk.named_curve(any_curve(desk)));
  EXPECT_EQ(desk.document().curves.size(), 1U);
}

TEST(AppPens, ATabletsPenPressesButtonsToo) {
  Desk desk("tablet-buttons");
  desk.begin();
  desk.app->of<TabletEvents>().arrived(1, replay::virtual_pen_identity());
  const auto viewport = desk.app->of<EditingSession>().editor().view().viewport;
  const PxPoint key = desk.interface->find("Key")->middle();
  const auto send = [&](bool tip) {
    desk.now_us += 3000;
    desk.app->of<TabletEvents>().report(1, desk.now_us,
                                        replay::virtual_pen_report({key, 0.5, true, tip, false, false}, viewport));
    desk.frames(1);
  };
  send(false);
  send(false);
  send(true);
  send(true);
  send(false);
  desk.frames();
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_TRUE(desk.document().curves.empty());
}

TEST(AppPens, TheBarrelButtonTurnsTheViewAndAClickOpensTheMenuAroundThePen) {
  Desk desk("barrel");
  desk.begin();
  const auto before = desk.app->of<Canvas>().view();
  desk.app->of<Pointer>().button(MouseButton::right, true, {500, 400});
  desk.app->of<Pointer>().moved({560, 400});
  desk.app->of<Pointer>().button(MouseButton::right, false, {560, 400});
  EXPECT_FALSE(desk.app->of<Canvas>().view() == before);
  EXPECT_FALSE(desk.app->of<PanelState>().radial.has_value());
  desk.app->of<Pointer>().button(MouseButton::right, true, {500, 400});
  desk.app->of<Pointer>().button(MouseButton::right, false, {500, 400});
  desk.frames();
  ASSERT_TRUE(desk.app->of<PanelState>().radial.has_value());
  desk.click("Erase##radial");
  EXPECT_EQ(desk.app->of<EditingSession>().editor().tool().kind, drawing::ToolKind::erase);
  EXPECT_FALSE(desk.app->of<PanelState>().radial.has_value());
}

TEST(AppPens, ATraceInPlaceOfATabletDrawsTheSame) {
  Desk desk("trace");
  desk.begin();
  // A trace of a reference and a target, written as a tablet's.
  replay::TraceWriter writer;
  writer.declare(0, replay::virtual_pen_device());
  std::int64_t time = 0;
  const auto viewport = desk.app->of<EditingSession>().editor().view().viewport;
  for (const PxPoint by : {PxPoint{0, 0}, PxPoint{0, -12}}) {
    for (const PxPoint& at : desk.named_curve(any_curve(desk), by)) {
      writer.report(0, time += 3333, replay::virtual_pen_report({at, 0.6, true, true, false, false}, viewport));
    }
    writer.report(0, time += 3333, replay::virtual_pen_report({{500, 500}, 0, true, false, false, false}, viewport));
  }
  std::ofstream(desk.path("pen.hid")) << writer.take();
  ASSERT_TRUE(desk.app->of<Files>().play_trace(desk.path("pen.hid")).ok());
  desk.frames(200);
  EXPECT_TRUE(desk.app->of<Player>().trace->finished());
  ASSERT_EQ(desk.document().curves.size(), 1U);
  EXPECT_TRUE(desk.document().curves.front()->target.has_value());
}

TEST(AppPens, OneFingerDrawsAndTwoTurnTheView) {
  Desk desk("fingers");
  desk.begin();
  const auto line = desk.named_curve(any_curve(desk));
  desk.app->of<Pointer>().finger(FingerKind::down, 7, line.front());
  for (const PxPoint& at : line) desk.app->of<Pointer>().finger(FingerKind::move, 7, at);
  desk.app->of<Pointer>().finger(FingerKind::up, 7, line.back());
  EXPECT_EQ(desk.document().curves.size(), 1U);
  const auto view = desk.app->of<Canvas>().view();
  desk.app->of<Pointer>().finger(FingerKind::down, 1, {400, 300});
  desk.app->of<Pointer>().finger(FingerKind::down, 2, {500, 300});
  desk.app->of<Pointer>().finger(FingerKind::move, 2, {560, 300});
  desk.app->of<Pointer>().finger(FingerKind::up, 1, {400, 300});
  desk.app->of<Pointer>().finger(FingerKind::up, 2, {560, 300});
  desk.frames();
  EXPECT_FALSE(desk.app->of<Canvas>().view() == view);
  EXPECT_EQ(desk.document().curves.size(), 1U);
  EXPECT_FALSE(desk.document().curves.front()->target.has_value());
}

TEST(AppPens, AFrameBetweenTwoMovesDoesNotEndAGestureOfTwoFingers) {
  Desk desk("fingers and frames");
  desk.begin();
  // The window says its size before every frame.
  const auto frame = [&] {
    desk.app->of<Pointer>().resized(desk.app->of<Canvas>().window(), 96);
    desk.frames(1);
  };
  const auto view = desk.app->of<Canvas>().view();
  desk.app->of<Pointer>().finger(FingerKind::down, 1, {400, 300});
  frame();
  desk.app->of<Pointer>().finger(FingerKind::down, 2, {500, 300});
  frame();
  desk.app->of<Pointer>().finger(FingerKind::move, 2, {560, 300});
  desk.frames();
  EXPECT_FALSE(desk.app->of<Canvas>().view() == view) << "the fingers of the frame before are still known";
  desk.app->of<Pointer>().finger(FingerKind::up, 2, {560, 300});
  frame();
  desk.app->of<Pointer>().finger(FingerKind::move, 1, {460, 360});
  EXPECT_FALSE(desk.app->of<EditingSession>().pen_is_drawing()) << "the finger that is left over does not draw";
  desk.app->of<Pointer>().finger(FingerKind::up, 1, {460, 360});
}

}  // namespace
}  // namespace penpose::app
