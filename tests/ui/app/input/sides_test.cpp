#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// The list of controls: pairs in one row, locks that hold, what moved; and both sides of a face at once.

namespace penpose::app {
namespace {

TEST(Sides, LeftAndRightStandInOneRow) {
  Desk desk("pair-row");
  desk.begin();
  const Area* left = desk.interface->find("slider brow_inner_L");
  const Area* right = desk.interface->find("slider brow_inner_R");
  ASSERT_TRUE(left != nullptr && right != nullptr);
  EXPECT_EQ(left->top, right->top);
  EXPECT_LE(left->right, right->left);
  desk.drag_slider("brow_inner_R", 0.3, 0.8);
  const rig::Parameter brow = desk.document().model->rig->parameters()[desk.index_of("brow_inner_R")];
  const double range = brow.maximum - brow.minimum;
  EXPECT_NEAR(desk.value_of("brow_inner_R"), brow.minimum + 0.8 * range, 0.05 * range);
  EXPECT_EQ(desk.value_of("brow_inner_L"), 0);
  desk.touch_row("name brow_inner_L");
  desk.click("Right to left##pair");
  EXPECT_EQ(desk.value_of("brow_inner_L"), desk.value_of("brow_inner_R"));
}

TEST(Sides, ALockedSliderDoesNotMove) {
  Desk desk("locked-slider");
  desk.begin();
  desk.app->of<Pointer>().resized({1280, 1400}, 96);  // so that the list shows it
  desk.frames(2);
  desk.hover("name jaw");
  desk.click("##lock jaw");
  const auto state = desk.app->of<EditingSession>().state();
  desk.drag_slider("jaw", 0.3, 0.9);
  EXPECT_EQ(desk.value_of("jaw"), 0);
  EXPECT_FALSE(desk.app->of<EditingSession>().shown().previews());
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
  desk.hover("name jaw");
  desk.click("##lock jaw");
  desk.drag_slider("jaw", 0.3, 0.9);
  EXPECT_GT(desk.value_of("jaw"), 0.5);
}

TEST(Sides, OnlyWhatMovedIsListedWhereThatIsAskedFor) {
  Desk desk("moved-only");
  desk.begin();
  desk.app->of<Controls>().set_parameter(desk.index_of("jaw"), 0.5);
  desk.click("Moved");
  EXPECT_NE(desk.interface->find("slider jaw"), nullptr);
  EXPECT_EQ(desk.interface->find("slider brow_inner_L"), nullptr);
  desk.click("Moved");
  EXPECT_NE(desk.interface->find("slider brow_inner_L"), nullptr);
}

TEST(Sides, APoseIsFlippedAndCopiedByKeys) {
  Desk desk("flip");
  desk.begin();
  desk.app->of<Controls>().set_parameter(desk.index_of("brow_inner_L"), 0.7);
  desk.press('m', false, true);
  EXPECT_EQ(desk.value_of("brow_inner_L"), 0);
  EXPECT_DOUBLE_EQ(desk.value_of("brow_inner_R"), 0.7);
  desk.press('m', true, true);
  EXPECT_DOUBLE_EQ(desk.value_of("brow_inner_L"), 0.7) << "right to left";
  const auto state = desk.app->of<EditingSession>().state();
  desk.press('m', true);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state) << "they are the same already, and that is told";
  EXPECT_FALSE(desk.app->of<Notices>().all().empty());
}

TEST(Sides, AStrokeOnOneSideWorksOnBothAndIsOneStep) {
  Desk desk("x-mirror");
  desk.begin();
  desk.press('m');
  ASSERT_TRUE(desk.app->of<Playback>().while_drawing().mirrors);
  std::string brow;
  for (const auto& curve : desk.document().model->curves) {
    if (curve.name.find("brow") != std::string::npos && curve.name.find("_L") != std::string::npos) brow = curve.name;
  }
  ASSERT_FALSE(brow.empty());
  const auto count = desk.app->of<EditingSession>().editor().history().undo_count();
  desk.stroke(desk.named_curve(brow));
  const auto raised = desk.named_curve(brow, {0, -10});
  desk.stroke(raised, false);
  desk.frames();
  const rig::Pose shown = desk.app->of<EditingSession>().shown().pose();
  desk.app->of<Pointer>().button(MouseButton::left, false, raised.back());
  desk.frames();
  double moved = 0;
  for (const char* name : {"brow_inner", "brow_outer"}) {
    const double left = desk.value_of(std::string(name) + "_L");
    EXPECT_DOUBLE_EQ(left, desk.value_of(std::string(name) + "_R")) << name;
    moved = std::max(moved, std::abs(left));
  }
  EXPECT_GT(moved, 0.05);
  EXPECT_NEAR(shown[desk.index_of("brow_inner_L")], shown[desk.index_of("brow_inner_R")], 1e-12)
      << "the other side follows the pen, too";
  EXPECT_GE(desk.app->of<EditingSession>().last_stroke().left_px(), 0) << "what the stroke came to is still told";
  desk.press('z', true);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), count + 1)
      << "both sides go back in one step";
  EXPECT_EQ(desk.value_of("brow_inner_R"), 0);
}

TEST(Sides, AMirroredSessionReplaysToTheSameState) {
  document::DocumentState state;
  {
    Desk desk("mirror-replay");
    desk.begin();
    desk.press('m');
    desk.press('k', false, true);
    pose_mouth(desk);
    state = desk.app->of<EditingSession>().state();
    std::filesystem::copy_file(desk.app->of<Recording>().path(), desk.path("recorded.session"));
  }
  Desk desk("mirror-replay", "builtin:demo", false);
  if (desk.app->of<Dialogs>().open() == Dialog::recover) desk.click("Start fresh");
  // Habits are not what a recording is played with.
  desk.app->of<Playback>().while_drawing().mirrors = desk.app->of<Playback>().while_drawing().auto_key = true;
  ASSERT_TRUE(desk.app->of<Files>().play_trace(desk.path("recorded.session")).ok());
  desk.app->of<Player>().trace->set_speed(16);
  for (int i = 0; i < 2000 && !desk.app->of<Player>().trace->finished(); ++i) desk.frames(1);
  ASSERT_TRUE(desk.app->of<Player>().trace->finished());
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
}

}  // namespace
}  // namespace penpose::app
