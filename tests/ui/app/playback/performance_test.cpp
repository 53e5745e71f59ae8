#include "ui/app/playback/performance.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/playback/frames.h"
#include "ui/app/view/outcome.h"

// The pen as a puppet's string.

namespace penpose::app {
namespace {

std::vector<rig::Parameter> three_controls() {
  std::vector<rig::Parameter> parameters(3);
  for (std::size_t i = 0; i < parameters.size(); ++i) parameters[i] = {"c" + std::to_string(i), 0, 0, 1};
  return parameters;
}

TEST(Performance, FramesBetweenTwoLooksAreFilledEvenly) {
  Performance performance(0.5, 10, {0.1, 0, 0.7});
  performance.take(0.55, {0.1, 0.1, 0.7});
  performance.take(0.85, {0.1, 0.7, 0.7});
  const auto keys = performance.keys(three_controls(), {0.1, 0, 0.7});
  ASSERT_TRUE(keys);
  EXPECT_EQ(keys->names, std::vector<std::string>{"c1"}) << "what the pen did not move is not keyed";
  ASSERT_EQ(keys->times_s, (std::vector<double>{0.5, 0.6, 0.7, 0.8}));
  EXPECT_EQ(keys->values[0], 0);
  for (int i = 1; i <= 3; ++i) EXPECT_NEAR(keys->values[static_cast<std::size_t>(i)], 0.2 * i, 1e-12) << i;
}

TEST(Performance, ASecondRoundTakesThePlaceOfTheFirst) {
  Performance performance(0, 10, {0, 0, 0});
  performance.take(0.1, {1, 0, 0});
  performance.take(0.2, {1, 0, 0});
  performance.take(0.3, {1, 0, 0});
  performance.take(0.1, {0, 0, 0.5});
  performance.take(0.2, {0, 0, 0.5});
  const auto keys = performance.keys(three_controls(), {0, 0, 0});
  ASSERT_TRUE(keys);
  ASSERT_EQ(keys->times_s.size(), 4U);
  EXPECT_EQ(keys->values, (std::vector<double>{0, 0, 0, 0.5, 0, 0.5, 1, 0}));
}

TEST(Performance, AboveAPoseOnlyWhatMovedIsShown) {
  Performance performance(0, 24, {0, 0, 0});
  performance.take(0.1, {0, 0.4, 0});
  EXPECT_EQ(performance.over({0.9, 0.9, 0.9}, {0, 0.5, 0}), (rig::Pose{0.9, 0.5, 0.9}));
}

TEST(Performance, ADrawnLineGoesToWhatItMeantAsThePenWentAlongItAndHoldsThere) {
  Performance performance(0, 10, {0.2, 0, 0});
  // The face was read otherwise while there was but a part of the line, and nothing moves any more at its end.
  performance.take(0.1, {0.2, 1, 0}, 30);
  performance.take(0.2, {0.2, 0, 0.9}, 60);
  performance.take(0.3, {0.2, 0, 0}, 120);
  performance.take(0.4, {0.2, 0, 0}, 120);
  const auto keys = performance.keys_of_line(three_controls(), {0.6, 0, 0});
  ASSERT_TRUE(keys);
  EXPECT_EQ(keys->names, std::vector<std::string>{"c0"}) << "what the line did not mean is not keyed";
  ASSERT_EQ(keys->values.size(), 5U);
  EXPECT_EQ(keys->values[0], 0.2);
  EXPECT_NEAR(keys->values[1], 0.3, 1e-12);
  EXPECT_NEAR(keys->values[2], 0.4, 1e-12);
  EXPECT_EQ(keys->values[3], 0.6);
  EXPECT_EQ(keys->values[4], 0.6);
  EXPECT_FALSE(performance.keys_of_line(three_controls(), {0.2, 0, 0}));
}

TEST(Performance, APenThatMovesNothingKeysNothing) {
  Performance performance(0, 24, {0.5, 0, 0});
  performance.take(0.2, {0.5, 0, 0});
  EXPECT_FALSE(performance.keys(three_controls(), {0.5, 0, 0}));
}

/// A lip's line with a target, the target in hand to be pulled.
void draw_smile(Desk& desk) {
  desk.begin();
  desk.press('b');
  desk.stroke(desk.named_curve("lip_lower"));
  desk.stroke(desk.named_curve("lip_lower", {0, 12}));
  desk.press('s');
}

/// Pulls the target by its middle, a frame of the screen for each step.
void pull(Desk& desk, int frames, double by) {
  ASSERT_FALSE(desk.document().curves.empty());
  const auto& target = *desk.document().curves.back()->target;
  const PxPoint middle = target.line[target.line.size() / 2];
  desk.app->of<Pointer>().moved(middle);
  desk.app->of<Pointer>().button(MouseButton::left, true, middle);
  for (int i = 1; i <= frames; ++i) {
    desk.app->of<Pointer>().moved(middle + PxPoint{0, by * i / frames});
    desk.frames(1);
  }
  desk.app->of<Pointer>().button(MouseButton::left, false, middle + PxPoint{0, by});
  desk.frames();
}

TEST(Performing, PullingAtATargetKeysWhatTheFaceDoesFrameByFrame) {
  Desk desk("perform");
  draw_smile(desk);
  desk.click("Key");
  const auto keyed = desk.document().pose;
  const auto curves = desk.document().curves;
  desk.press(' ', false, true);
  ASSERT_TRUE(desk.app->of<Playback>().while_drawing().performs);
  pull(desk, 60, 20);  // 60 frames of 16 ms
  const auto timeline = desk.document().timeline;
  // Time runs from where the pen has gone 5 of its 20 px.
  EXPECT_NEAR(timeline->keys.back().time_s, 0.75 * 0.96, 2.0 / 24);
  EXPECT_LE(timeline->keys.size(), 8U) << "the keys that its curves need, not one a frame";
  EXPECT_EQ(timeline->keys.front().pose, document::SharedPose(keyed)) << "it begins with what was there";
  EXPECT_NE(timeline->keys.back().pose, document::SharedPose(keyed));
  for (const auto& key : timeline->keys) EXPECT_DOUBLE_EQ(key.time_s, on_frame(key.time_s, 24));
  EXPECT_EQ(curves, desk.document().curves) << "the target goes back: the pen was a string";
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), timeline->keys.back().time_s);
  EXPECT_EQ(desk.document().pose, rig::Pose(timeline->keys.back().pose));
  desk.press('z', true);
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U) << "one step takes the take back";
  EXPECT_EQ(desk.document().pose, keyed);
}

TEST(Performing, ASecondTakeKeepsWhatTheFirstOneMoved) {
  Desk desk("layers");
  draw_smile(desk);
  desk.click("Key");
  desk.press(' ', false, true);
  pull(desk, 60, 15);
  const auto first = desk.document().timeline;
  desk.app->of<Playback>().go_to(0);
  desk.stroke(desk.named_curve("brow_L"));  // nothing: the tool is not one that draws
  desk.press('b');
  desk.stroke(desk.named_curve("brow_L"));
  const auto brow = desk.named_curve("brow_L", {0, -12});
  desk.app->of<Pointer>().moved(brow.front());
  desk.app->of<Pointer>().button(MouseButton::left, true, brow.front());
  for (const PxPoint& p : brow) {
    desk.app->of<Pointer>().moved(p);
    desk.frames(3);
  }
  desk.app->of<Pointer>().button(MouseButton::left, false, brow.back());
  desk.frames();
  const auto second = desk.document().timeline;
  ASSERT_GE(second->keys.size(), first->keys.size());
  const auto parameters = desk.document().model->rig->parameters();
  bool moved = false;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool brows = parameters[i].name.starts_with("brow");
    for (std::size_t k = 0; k < first->keys.size(); ++k) {
      if (const auto value = document::sample(*second, i, first->keys[k].time_s); value && !brows) {
        EXPECT_NEAR(*value, first->keys[k].pose[i], 1e-9) << parameters[i].name << " at key " << k;
      }
      moved = moved || (brows && second->keys[k].pose[i] != first->keys[k].pose[i]);
    }
  }
  EXPECT_TRUE(moved);
}

TEST(Performing, AFaceThatIsBehindThePenSettlesWhileThePenRests) {
  Desk desk("settles");
  draw_smile(desk);
  desk.click("Key");
  desk.press(' ', false, true);
  const auto& target = *desk.document().curves.back()->target;
  const PxPoint middle = target.line[target.line.size() / 2];
  desk.app->of<Pointer>().moved(middle);
  desk.app->of<Pointer>().button(MouseButton::left, true, middle);
  desk.app->of<Pointer>().moved(middle + PxPoint{0, 8});
  desk.frames(2);
  desk.app->of<Pointer>().moved(middle + PxPoint{0, 30});
  desk.frames(40);
  const rig::Pose rested = desk.app->of<EditingSession>().shown().pose();
  desk.frames(40);
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), rested) << "it comes to rest";
  desk.app->of<Pointer>().button(MouseButton::left, false, middle + PxPoint{0, 30});
  desk.frames();
  EXPECT_EQ(rig::Pose(desk.document().timeline->keys.back().pose), rested) << "and is keyed as it rests";
}

TEST(Performing, ATouchOfATargetIsStillATouch) {
  Desk desk("touch");
  draw_smile(desk);
  desk.press(' ', false, true);
  const auto before = desk.document().timeline;
  pull(desk, 1, 1);
  EXPECT_EQ(desk.document().timeline, before);
  EXPECT_FALSE(desk.app->of<Performer>().performing());
}

TEST(Performing, TheLineBelowSaysWhatTheTakeKeyedAndNotWhatAStrokeBeforeItDid) {
  Desk desk("take-said");
  draw_smile(desk);
  const std::string stroke = outcome_of(desk.app->of<EditingSession>());
  ASSERT_FALSE(stroke.empty());
  desk.press(' ', false, true);
  pull(desk, 24, 20);
  const std::string take = outcome_of(desk.app->of<EditingSession>());
  EXPECT_NE(take.find("frames are keyed"), std::string::npos) << take;
  // The next thing that happens is what there is to say.
  desk.app->of<Playback>().undo();
  desk.frames();
  EXPECT_EQ(outcome_of(desk.app->of<EditingSession>()).find("frames are keyed"), std::string::npos);
}

}  // namespace
}  // namespace penpose::app
