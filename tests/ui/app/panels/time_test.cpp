#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/playback/frames.h"

// Time as an animator counts it: frames, keys that are moved and copied, loops, auto-key.

namespace penpose::app {
namespace {

void drag(Desk& desk, const std::string& strip, double from, double to) {
  const Area area = *desk.interface->find(strip);
  const auto at = [&](double share) { return PxPoint{area.left + share * area.width(), area.middle().y}; };
  desk.app->of<Pointer>().moved(at(from));
  desk.app->of<Pointer>().button(MouseButton::left, true, at(from));
  desk.frames();
  for (int i = 1; i <= 4; ++i) {
    desk.app->of<Pointer>().moved(at(from + (to - from) * i / 4));
    desk.frames(2);
  }
  desk.app->of<Pointer>().button(MouseButton::left, false, at(to));
  desk.frames();
}

double moved_jaw(Desk& desk, double value) {
  desk.app->of<Controls>().set_parameter(*rig::find_parameter(desk.document().model->rig->parameters(), "jaw"), value);
  return value;
}

double jaw(const Desk& desk) {
  return desk.document().pose[*rig::find_parameter(desk.document().model->rig->parameters(), "jaw")];
}

TEST(Time, DraggingThePlayheadOffAKeyLeavesTheKeyWhereItIs) {
  Desk desk("ruler");
  desk.begin();
  desk.click("Key");
  drag(desk, "ruler", 0.01, 0.5);
  ASSERT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_EQ(desk.document().timeline->keys.front().time_s, 0);
  EXPECT_GT(desk.app->of<Playback>().time_s(), 1.5);
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), on_frame(desk.app->of<Playback>().time_s(), 24)) << "on a frame";
  drag(desk, "track", 0.01, 0.5);
  EXPECT_GT(desk.document().timeline->keys.front().time_s, 1.5) << "below it keys are moved";
}

TEST(Time, AFrameIsTypedAndSteppedTo) {
  Desk desk("frame-field");
  desk.begin();
  desk.click("##frame");
  for (int i = 0; i < 3; ++i) desk.hit_backspace();
  desk.interface->text("36");
  desk.frames();
  desk.hit_return();
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 1.5);
  desk.press('.', false, true);
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 37.0 / 24);
  desk.press(',', false, true);
  desk.press(',', false, true);
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 35.0 / 24);
  desk.app->of<Playback>().set_rate(30);
  desk.frames();
  desk.press('.', false, true);
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 44.0 / 30) << "from 43.75 to the next one of 30";
  EXPECT_EQ(load_settings(desk.path("config")).rate, 30) << "it is kept for the next model";
}

TEST(Time, AFileOpensWithTheRateOfItsKeys) {
  Desk desk("rate");
  desk.begin();
  for (const double time : {0.0, 5.0 / 30, 7.0 / 30})
    ASSERT_TRUE(desk.app->of<EditingSession>().perform(document::SetKey{time, {}}));
  ASSERT_TRUE(desk.app->of<Files>().save(desk.path("thirty.glb")).ok());
  EXPECT_EQ(desk.app->of<Playback>().rate(), 24);
  ASSERT_TRUE(desk.app->of<Files>().open(desk.path("thirty.glb")).ok());
  EXPECT_EQ(desk.app->of<Playback>().rate(), 30);
}

TEST(Time, APoseIsCopiedToAnotherMomentAndUndoneInOneStep) {
  Desk desk("copy");
  desk.begin();
  const double open = moved_jaw(desk, 0.6);
  desk.click("Key");
  desk.app->of<Keys>().name("open");
  desk.press('c', true);
  desk.app->of<Playback>().go_to(1);
  moved_jaw(desk, 0.1);
  desk.click("Key");
  desk.app->of<Playback>().go_to(2);
  desk.press('v', true);
  ASSERT_EQ(desk.document().timeline->keys.size(), 3U);
  EXPECT_EQ(desk.document().timeline->keys.back().time_s, 2);
  EXPECT_EQ(desk.document().timeline->keys.back().name, "open");
  EXPECT_DOUBLE_EQ(jaw(desk), open);
  desk.press('z', true);
  EXPECT_EQ(desk.document().timeline->keys.size(), 2U);
  EXPECT_DOUBLE_EQ(jaw(desk), 0.1) << "key and pose are one step";
  desk.press('z', true, true);
  EXPECT_EQ(desk.document().timeline->keys.size(), 3U);
  EXPECT_DOUBLE_EQ(jaw(desk), open);
}

TEST(Time, UndoSkipsMovesInTimeAndThePlayheadReturnsWithThePose) {
  Desk desk("undo-time");
  desk.begin();
  desk.click("Key");
  desk.app->of<Playback>().go_to(1);
  moved_jaw(desk, 0.5);
  desk.click("Key");
  desk.app->of<Playback>().go_to(0);
  desk.app->of<Playback>().go_to(0.5);
  desk.app->of<Playback>().go_to(0.25);
  ASSERT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 0.25);
  desk.press('z', true);
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U) << "the key is taken back, not three looks at other moments";
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), desk.document().time_s);
  EXPECT_DOUBLE_EQ(jaw(desk), 0.5) << "the pose is there that was keyed";
  const auto steps = desk.app->of<EditingSession>().steps().list();
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].text, "Key the pose");
  EXPECT_EQ(steps[1].text, "Set a control");
  EXPECT_FALSE(steps[1].undone);
  EXPECT_TRUE(steps[2].undone);
  desk.press('h', true);
  desk.click("As it was opened##step 0");
  EXPECT_TRUE(desk.document().timeline->keys.empty());
  desk.click("Key the pose##step 3");
  EXPECT_EQ(desk.document().timeline->keys.size(), 2U) << "the list goes forward, too";
}

TEST(Time, WhatIsPlayedIsTheLoop) {
  Desk desk("loop");
  desk.begin();
  for (const double time : {0.0, 1.0, 2.0})
    ASSERT_TRUE(desk.app->of<EditingSession>().perform(document::SetKey{time, {}}));
  desk.app->of<Playback>().go_to(0.5);
  desk.press('[');
  desk.app->of<Playback>().go_to(1);
  desk.press(']');
  desk.press(' ');
  double least = 9;
  double most = 0;
  for (int i = 0; i < 120; ++i) {
    desk.frames(1);
    least = std::min(least, desk.app->of<Playback>().time_s());
    most = std::max(most, desk.app->of<Playback>().time_s());
  }
  EXPECT_GE(least, 0.5);
  EXPECT_LE(most, 1.0);
  EXPECT_GT(most, 0.9);
  desk.press(' ');
  desk.press('\\');
  EXPECT_FALSE(desk.app->of<Playback>().loop().any());
}

TEST(Time, AutoKeyKeysEveryChangeWithItsOwnUndo) {
  Desk desk("auto-key");
  desk.begin();
  desk.press('k', false, true);
  ASSERT_TRUE(desk.app->of<Playback>().while_drawing().auto_key);
  moved_jaw(desk, 0.4);
  ASSERT_EQ(desk.document().timeline->keys.size(), 1U);
  desk.app->of<Playback>().go_to(1);
  desk.frames();
  pose_mouth(desk);
  ASSERT_EQ(desk.document().timeline->keys.size(), 2U);
  EXPECT_EQ(desk.document().timeline->keys.back().time_s, 1);
  EXPECT_EQ(desk.document().timeline->keys.back().pose, document::SharedPose(desk.document().pose));
  desk.press('z', true);
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U) << "the stroke and its key are one step";
  EXPECT_EQ(desk.document().curves.size(), 1U);
}

}  // namespace
}  // namespace penpose::app
