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

/// Keys at 0 and at another moment, where the jaw is open; back at 0.
void key_jaw(Desk& desk, double time_s, double open) {
  desk.begin();
  desk.click("Key");
  desk.app->of<Playback>().go_to(time_s);
  moved_jaw(desk, open);
  desk.click("Key");
  desk.app->of<Playback>().go_to(0);
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
  key_jaw(desk, 1, 0.5);
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
  desk.click("Opened##step 0");
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

TEST(Time, PlayStopsOnAFrameWithItsPoseAndAKeyIsSetThere) {
  Desk desk("stop-on-frame");
  key_jaw(desk, 2, 0.8);
  for (const char* stops : {"key", "button", "tool"}) {
    desk.press(' ');
    ASSERT_TRUE(desk.app->of<Playback>().playing());
    desk.frames(17);
    desk.now_us += 5'000;
    desk.frames(1);
    const double playing_s = desk.app->of<Playback>().time_s();
    EXPECT_NE(playing_s, on_frame(playing_s, 24)) << "the clock knows no frames";
    if (stops == std::string("key")) desk.press(' ');
    if (stops == std::string("button")) desk.click("Stop");
    if (stops == std::string("tool")) desk.click("Pose");
    EXPECT_FALSE(desk.app->of<Playback>().playing());
    const double time_s = desk.app->of<Playback>().time_s();
    EXPECT_DOUBLE_EQ(time_s, on_frame(time_s, 24)) << stops;
    EXPECT_DOUBLE_EQ(desk.document().time_s, time_s) << stops;
    EXPECT_GT(jaw(desk), 0) << "the pose of that frame is taken";
    EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
  }
  desk.click("Key");
  for (const auto& key : desk.document().timeline->keys) EXPECT_DOUBLE_EQ(key.time_s, on_frame(key.time_s, 24));
  EXPECT_EQ(desk.document().timeline->keys.size(), 3U);
  // A frame that is typed between two is none; a key that lies there is gone to.
  desk.app->of<Playback>().go_to(30.4 / 24);
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 30.0 / 24);
  ASSERT_TRUE(desk.app->of<EditingSession>().perform(document::SetKey{30.4 / 24, {}}));
  desk.app->of<Playback>().go_to(30.4 / 24);
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 30.4 / 24);
}

/// How many lines of posing are shown.
std::ptrdiff_t shown_targets(Desk& desk) {
  desk.frames();
  const auto& curves = desk.app->of<CanvasDrawing>().curves;
  return std::count_if(curves.begin(), curves.end(),
                       [](const auto& one) { return one.kind == render::CurveKind::target; });
}

TEST(Time, LinesAreShownAtTheMomentThatTheyWereDrawnAtAndNotWhilePlaying) {
  Desk desk("lines-in-time");
  desk.begin();
  pose_mouth(desk);
  desk.click("Key");
  ASSERT_EQ(shown_targets(desk), 1);
  desk.press(' ');
  desk.frames(2);
  ASSERT_TRUE(desk.app->of<Playback>().playing());
  EXPECT_EQ(shown_targets(desk), 0) << "nothing lies over what is played";
  desk.press(' ');
  desk.app->of<Playback>().scrub(1);
  EXPECT_EQ(shown_targets(desk), 0) << "the face is another one there";
  desk.app->of<Playback>().end_scrub();
  EXPECT_EQ(shown_targets(desk), 0);
  // What is not seen is not taken in hand either.
  desk.click("Select");
  const auto& line = desk.document().curves.front()->target->line;
  const auto pose = desk.document().pose;
  desk.stroke({line[line.size() / 2], line[line.size() / 2] + PxPoint{0, 25}});
  EXPECT_EQ(desk.document().pose, pose);
  // A line of that other moment, and back.
  desk.click("Pose");
  pose_mouth(desk);
  EXPECT_EQ(shown_targets(desk), 1);
  desk.click("Key");
  EXPECT_EQ(shown_targets(desk), 1);
  desk.press(',');
  ASSERT_EQ(desk.document().time_s, 0);
  EXPECT_EQ(shown_targets(desk), 1) << "the first line is back, the other one is gone";
  EXPECT_TRUE(desk.app->of<EditingSession>().moments().shows(desk.document().curves.front()->id));
  EXPECT_FALSE(desk.app->of<EditingSession>().moments().shows(desk.document().curves.back()->id));
}

TEST(Time, APoseThatIsKeyedElsewhereTakesItsLinesAlong) {
  Desk desk("lines-carried");
  desk.begin();
  desk.click("Key");
  pose_mouth(desk);
  ASSERT_EQ(shown_targets(desk), 1);
  desk.app->of<Playback>().go_to(1);
  ASSERT_EQ(desk.document().time_s, 0) << "the pose is on no key yet";
  EXPECT_EQ(shown_targets(desk), 1) << "it is the pose that they were drawn for";
  desk.click("Key");
  EXPECT_EQ(shown_targets(desk), 1);
  desk.press(',');
  EXPECT_EQ(shown_targets(desk), 0);
  desk.press('.');
  EXPECT_EQ(shown_targets(desk), 1);
}

}  // namespace
}  // namespace penpose::app
