#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// Sketched controls in hand: taps, names, mirrors; and targets that are drawn over.

namespace penpose::app {
namespace {

TEST(Controls, ATapWithTheRigToolLeavesTheFaceAndSaysWhatToDraw) {
  Desk desk("rig-tap");
  desk.begin();
  sketch_chin(desk);
  desk.app->of<Controls>().set_parameter(0, desk.document().model->rig->parameters()[0].maximum);
  const auto pose = desk.document().pose;
  const auto state = desk.app->of<EditingSession>().state();
  desk.stroke({{450, 300}, {452, 301}}, false);
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), pose) << "the face does not fall back to rest";
  desk.app->of<Pointer>().button(MouseButton::left, false, {452, 301});
  desk.frames();
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), pose);
  EXPECT_TRUE(desk.says("draw around everything on the face that may move"));
  EXPECT_FALSE(desk.says("line:"));
  const bool unsaved = desk.app->of<EditingSession>().unsaved();
  desk.app->of<EditingSession>().mark_saved();
  desk.stroke({{450, 300}, {452, 301}});
  EXPECT_FALSE(desk.app->of<EditingSession>().unsaved()) << "there is nothing to save of a tap";
  EXPECT_TRUE(unsaved);
  // The next line is the first of a control, with its own choices.
  desk.app->of<Controls>().choose_for_new(articulation::Mode::rotate, {});
  desk.stroke(around({517, 530}, 60, 32));
  ASSERT_TRUE(desk.document().pending);
  EXPECT_FALSE(desk.says("Nothing changed")) << "it is over";
  EXPECT_EQ(desk.document().pending->sketch.mode, articulation::Mode::rotate);
  EXPECT_FALSE(desk.document().pending->sketch.general.empty());
}

TEST(Controls, ASwingEndsWithTheListOfControlsAndTheFaceIsAsItWas) {
  Desk desk("swing-end");
  desk.begin();
  desk.click("Controls");
  desk.app->of<Controls>().select("jaw");
  desk.frames();
  desk.click("Swing");
  desk.frames(20);
  EXPECT_NE(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
  desk.click("Parameters");
  desk.frames();
  EXPECT_FALSE(desk.app->of<Controls>().swings());
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
}

TEST(Controls, OnlyStrokesSayWhatTheyMoved) {
  Desk desk("moved");
  desk.begin();
  pose_mouth(desk);
  EXPECT_FALSE(desk.app->of<EditingSession>().last_stroke().movements().empty());
  desk.click("Rest pose");
  EXPECT_TRUE(desk.app->of<EditingSession>().last_stroke().movements().empty())
      << "what is set at once needs no telling";
}

TEST(Controls, ATapBetweenTheStepsLosesNothingAndNamesTheStep) {
  Desk desk("step-tap");
  desk.begin();
  desk.click("Rig");
  desk.stroke(around({517, 530}, 60, 32));
  desk.stroke(around({517, 530}, 28, 14));
  const auto state = desk.app->of<EditingSession>().state();
  desk.stroke({{517, 540}, {518, 541}});
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state) << "a tap is no target";
  EXPECT_TRUE(desk.says("draw a line where the feature should go"));
}

TEST(Controls, ATapWithThePoseToolDrawsNothing) {
  Desk desk("pose-tap");
  desk.begin();
  desk.hit_escape();  // the features that are shown on opening are touched no more
  const auto line = desk.named_curve(any_curve(desk));
  desk.stroke({line[3], line[3] + PxPoint{2, 1}});
  EXPECT_TRUE(desk.document().curves.empty());
  EXPECT_TRUE(desk.says("draw along a feature of the face"));
  desk.stroke(line);
  desk.stroke({line[3], line[3] + PxPoint{2, 1}});
  EXPECT_FALSE(desk.document().curves.front()->target);
  EXPECT_TRUE(desk.says("draw a line where the feature should go"));
}

TEST(Controls, AMirroredControlHasAGoodNameAndIsInHand) {
  Desk desk("mirror");
  desk.begin();
  sketch_chin(desk);
  desk.click("##rename");
  desk.type("dimple");
  desk.hit_return();
  EXPECT_FALSE(desk.says("control 1")) << "nothing is said of a name that is gone";
  desk.click("Mirror");
  EXPECT_EQ(desk.document().model->deformers->deformers().back()->sketch().name, "dimple mirrored");
  EXPECT_EQ(desk.app->of<Controls>().selected(), "dimple mirrored");
  EXPECT_TRUE(desk.says("dimple mirrored is ready"));
  // Sides change places where a name has one.
  desk.app->of<Controls>().select("dimple");
  desk.frames();
  desk.click("##rename");
  desk.type("left dimple");
  desk.hit_return();
  desk.click("Mirror");
  EXPECT_EQ(desk.app->of<Controls>().selected(), "right dimple");
  desk.app->of<Controls>().select("left dimple");
  desk.frames();
  const auto state = desk.app->of<EditingSession>().state();
  desk.click("Mirror");
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
  EXPECT_EQ(desk.app->of<Controls>().selected(), "left dimple") << "there is a right one already, and it is told";
  EXPECT_TRUE(desk.app->of<Notices>().all().back().is_error);
}

TEST(Controls, APartOfATargetIsDrawnOverAndTheRestStaysBeforeAndAfterThePenLifts) {
  Desk desk("over");
  desk.begin();
  pose_mouth(desk);
  const auto before = *desk.document().curves.front()->target;
  const auto camera =
      *geometry::Camera::make(desk.app->of<Canvas>().view().camera, desk.app->of<Canvas>().view().viewport);
  const auto seen = [&](std::size_t i) { return *camera.project(before.points[i]); };
  desk.click("Redraw");
  const std::size_t n = before.points.size();
  desk.stroke({seen(2 * n / 3), seen(5 * n / 6) + PxPoint{0, -25}, seen(n - 1) + PxPoint{0, -30}}, false);
  const auto* shown = desk.app->of<EditingSession>().shown().live().target();
  ASSERT_NE(shown, nullptr) << "all of it is shown while a part is drawn";
  for (std::size_t i = 0; i < n / 2; ++i) EXPECT_EQ(shown->points[i], before.points[i]) << i;
  desk.app->of<Pointer>().button(MouseButton::left, false, seen(n - 1) + PxPoint{0, -30});
  desk.frames();
  const auto after = *desk.document().curves.front()->target;
  for (std::size_t i = 0; i < n / 2; ++i) EXPECT_EQ(after.points[i], before.points[i]) << i;
  EXPECT_GT(after.points[n - 1].y, before.points[n - 1].y);
}

TEST(Controls, DrawingALineOfAControlAgainEndsWithTheLineAndByEscape) {
  Desk desk("redraw-ends");
  desk.begin();
  sketch_chin(desk);
  desk.click("Pose");
  desk.app->of<PanelState>().controls_tab = true;
  const std::string name = desk.document().model->deformers->deformers().back()->sketch().name;
  desk.app->of<Controls>().select(name);
  desk.frames();
  const auto tool = [&] { return desk.app->of<EditingSession>().editor().tool().kind; };
  desk.app->of<Controls>().redraw(name, articulation::CurveRole::target);
  ASSERT_EQ(tool(), drawing::ToolKind::redraw);
  // A tap is no line: it is tried again.
  desk.stroke({{450, 300}, {451, 300}});
  EXPECT_EQ(tool(), drawing::ToolKind::redraw);
  const auto before = desk.document().model->deformers;
  const auto mouth = desk.named_curve(any_curve(desk));
  const PxPoint middle = mouth[mouth.size() / 2] + PxPoint{0, 55};
  desk.stroke({middle + PxPoint{-26, 28}, middle + PxPoint{0, 38}, middle + PxPoint{26, 28}});
  ASSERT_NE(desk.document().model->deformers, before);
  EXPECT_EQ(tool(), drawing::ToolKind::pose) << "the line is drawn: what was in hand is again";
  // Other lines, until Escape.
  desk.app->of<Controls>().redraw(name, articulation::CurveRole::general);
  desk.app->of<Controls>().redraw(name, articulation::CurveRole::specific);
  ASSERT_EQ(tool(), drawing::ToolKind::redraw);
  desk.hit_escape();
  EXPECT_EQ(tool(), drawing::ToolKind::pose);
  // Whoever takes another tool meanwhile keeps it.
  desk.app->of<Controls>().redraw(name, articulation::CurveRole::target);
  desk.click("Draw");
  desk.hit_escape();
  EXPECT_EQ(tool(), drawing::ToolKind::draw);
}

TEST(Controls, RedrawOfATouchedTargetIsOfOneLine) {
  Desk desk("redraw-curve");
  desk.begin();
  pose_mouth(desk);
  desk.click("Select");
  const auto& target = *desk.document().curves.front()->target;
  const PxPoint at = target.line[target.line.size() / 2];
  desk.stroke({at, at + PxPoint{1, 0}});
  desk.click("Redraw##curve");
  ASSERT_EQ(desk.app->of<EditingSession>().editor().tool().kind, drawing::ToolKind::oversketch);
  const auto line = target.line;
  desk.stroke({line[20], line[30] + PxPoint{0, -8}, line[40]});
  ASSERT_NE(desk.document().curves.front()->target->line, line);
  EXPECT_TRUE(desk.app->of<ToolInHand>().now().selects) << "Select is in hand again";
}

TEST(Controls, AControlThatIsLockedStaysInTheListOfTheMovedOnes) {
  Desk desk("moved-locked");
  desk.begin();
  const std::string moved = moved_with_mouth(desk);
  desk.click("Moved");
  const std::string slider = "slider " + moved;
  ASSERT_NE(desk.interface->find(slider), nullptr);
  desk.turn_lock(moved);
  const auto index = *rig::find_parameter(desk.document().model->rig->parameters(), moved);
  ASSERT_EQ(desk.document().pose[index], desk.document().model->rig->parameters()[index].rest)
      << "the line is solved again without it";
  ASSERT_NE(desk.interface->find(slider), nullptr) << "it can be freed where it was locked";
  desk.turn_lock(moved);
  EXPECT_NE(desk.document().pose[index], desk.document().model->rig->parameters()[index].rest);
  // One that is away from rest stays in any case, and what was never listed does not come.
  desk.app->of<EditingSession>().perform(document::LockParameters{{"jaw"}, true});
  desk.app->of<Controls>().set_parameter(index, desk.document().model->rig->parameters()[index].maximum);
  desk.turn_lock(moved);
  EXPECT_NE(desk.interface->find(slider), nullptr);
  EXPECT_EQ(
      desk.interface->find("slider jaw") != nullptr,
      std::abs(desk.document().pose[*rig::find_parameter(desk.document().model->rig->parameters(), "jaw")]) > 0.005);
}

}  // namespace
}  // namespace penpose::app
