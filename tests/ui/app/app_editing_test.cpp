#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// What is dragged, chosen, typed, named and replayed.

namespace penpose::app {
namespace {

TEST(AppEditing, TheFaceFollowsATargetThatIsDraggedOrDrawnOverBeforeThePenLifts) {
  Desk desk("held");
  desk.begin();
  pose_mouth(desk);
  const auto id = desk.document().curves.front()->id;
  const auto state = desk.app->of<EditingSession>().state();
  const auto settled = desk.document().pose;
  const auto line = desk.document().curves.front()->target->line;
  desk.click("Select");
  const PxPoint from = line[line.size() / 2];
  // As far as the lips can go: at a limit the reading at pen-up may do without the control that stands there.
  desk.stroke({from, from + PxPoint{0, 6}}, false);
  EXPECT_NE(desk.app->of<EditingSession>().shown().pose(), settled) << "it follows";
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state) << "it is no command yet";
  const auto shown = desk.app->of<EditingSession>().shown().pose();
  desk.app->of<Pointer>().button(MouseButton::left, false, from + PxPoint{0, 6});
  double apart = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) apart = std::max(apart, std::abs(shown[i] - desk.document().pose[i]));
  EXPECT_LT(apart, 0.3) << "what was shown is about what came of it";
  // From another view the target is moved as it is seen there.
  desk.click("3/4");
  const auto camera =
      geometry::Camera::make(desk.app->of<Canvas>().view().camera, desk.app->of<Canvas>().view().viewport);
  const auto& target = *desk.document().curves.front()->target;
  const PxPoint seen = *camera->project(target.points[target.points.size() / 2]);
  desk.stroke({seen, seen + PxPoint{0, -20}});
  ASSERT_EQ(desk.document().curves.front()->id, id);
  const auto& moved = *desk.document().curves.front()->target;
  EXPECT_NEAR(camera->project(moved.points[moved.points.size() / 2])->y, seen.y - 20, 4);
  // Redrawing a part.
  desk.click("Front");
  desk.click("Redraw");
  const auto before = desk.app->of<EditingSession>().state();
  const auto now = desk.named_curve(any_curve(desk), {0, 10});
  desk.stroke({now[now.size() / 3], now[now.size() / 2], now[2 * now.size() / 3]}, false);
  EXPECT_TRUE(desk.app->of<EditingSession>().shown().live().active());
  EXPECT_EQ(desk.app->of<EditingSession>().state(), before);
  desk.app->of<Pointer>().button(MouseButton::left, false, now[2 * now.size() / 3]);
  EXPECT_NE(desk.app->of<EditingSession>().state(), before);
}

/// The two lassos of a control below the mouth.
PxPoint lasso_chin(Desk& desk) {
  const auto mouth = desk.named_curve(any_curve(desk));
  const PxPoint middle = mouth[mouth.size() / 2] + PxPoint{0, 55};
  desk.stroke(around(middle, 60, 32));
  desk.stroke(around(middle, 28, 14));
  return middle;
}

TEST(AppEditing, AControlsFeatureModeAndSurfaceAreChosenBeforeAndWhileItIsMade) {
  Desk desk("choices");
  desk.begin();
  desk.click("Rig");
  desk.click("Turn");
  EXPECT_EQ(desk.document().pending->sketch.mode, articulation::Mode::rotate);
  const PxPoint middle = lasso_chin(desk);
  ASSERT_TRUE(desk.document().pending);
  // The feature that was found is shown, from wherever one looks.
  EXPECT_GT(desk.app->of<EditingSession>().shown().sketch().reference().size(), 10U);
  const auto shows_feature = [&] {
    const auto& curves = desk.app->of<CanvasDrawing>().curves;
    return std::any_of(curves.begin(), curves.end(), [](const auto& curve) {
      return curve.kind == render::CurveKind::reference && curve.points.size() > 10;
    });
  };
  EXPECT_TRUE(shows_feature());
  // It is drawn by hand in its place, and then found again.
  desk.click("Draw the feature myself");
  EXPECT_NE(desk.app->of<ToolInHand>().hint().find("3 of 4"), std::string::npos);
  desk.stroke({middle + PxPoint{-20, 4}, middle + PxPoint{20, 4}});
  EXPECT_FALSE(desk.document().pending->sketch.reference.empty());
  EXPECT_TRUE(shows_feature());
  desk.click("Find the feature by itself");
  EXPECT_TRUE(desk.document().pending->sketch.reference.empty());
  // Mode and surface of what is half made; its strokes stay.
  desk.click("Slide");
  EXPECT_EQ(desk.document().pending->sketch.mode, articulation::Mode::translate);
  EXPECT_FALSE(desk.document().pending->sketch.specific.empty());
  desk.click("Over: what it lies on##surface");
  desk.click("a ball");
  ASSERT_TRUE(std::holds_alternative<articulation::Sphere>(desk.document().pending->sketch.surface));
  EXPECT_FALSE(desk.document().pending->sketch.specific.empty());
  // It plays to and fro while the target is drawn.
  desk.click("Swing");
  desk.stroke({middle + PxPoint{-26, 18}, middle + PxPoint{0, 26}, middle + PxPoint{26, 18}}, false);
  desk.frames(3);
  const auto first = desk.app->of<EditingSession>().shown().pose();
  desk.frames(20);
  EXPECT_NE(desk.app->of<EditingSession>().shown().pose(), first);
  desk.app->of<Pointer>().button(MouseButton::left, false, middle + PxPoint{26, 18});
  desk.frames();
  ASSERT_FALSE(desk.document().pending) << desk.app->of<Notices>().all().back().text;
  const auto& made = desk.document().model->deformers->deformers().back();
  EXPECT_EQ(made->mode(), articulation::Mode::translate);
  EXPECT_TRUE(std::holds_alternative<articulation::Sphere>(made->sketch().surface));
  desk.click("Swing");
  EXPECT_FALSE(desk.app->of<Controls>().swings());
}

TEST(AppEditing, AControlIsDrawnAgainAndTheFaceShowsItWhileItIsDrawn) {
  Desk desk("again");
  desk.begin();
  desk.click("Rig");
  const PxPoint middle = lasso_chin(desk);
  desk.stroke({middle + PxPoint{-26, 18}, middle + PxPoint{0, 26}, middle + PxPoint{26, 18}});
  const auto count = desk.document().model->deformers->deformers().size();
  const auto made = desk.document().model->deformers->deformers().back();
  desk.click("Target");
  const auto rest = desk.app->of<EditingSession>().shown().pose();
  desk.stroke({middle + PxPoint{-26, 38}, middle + PxPoint{0, 46}, middle + PxPoint{26, 38}}, false);
  EXPECT_NE(desk.app->of<EditingSession>().shown().pose(), rest);
  EXPECT_EQ(desk.document().model->deformers->deformers().back(), made);
  desk.app->of<Pointer>().button(MouseButton::left, false, middle + PxPoint{26, 38});
  desk.frames();
  ASSERT_EQ(desk.document().model->deformers->deformers().size(), count);
  EXPECT_NE(desk.document().model->deformers->deformers().back()->sketch().target, made->sketch().target);
  // Its place in the list.
  desk.click("Up");
  EXPECT_EQ(desk.document().model->deformers->deformers()[count - 2]->sketch().name, made->sketch().name);
  desk.click("Down");
  EXPECT_EQ(desk.document().model->deformers->deformers().back()->sketch().name, made->sketch().name);
}

TEST(AppEditing, NumbersAndRangesAreTypedWithThePenAlone) {
  Desk desk("numbers");
  desk.begin();
  const auto jaw = [&] { return *rig::find_parameter(desk.document().model->rig->parameters(), "jaw"); };
  const auto open = [&] {
    desk.app->of<PanelState>().own.of<ParameterList>().filter = "jaw";
    desk.frames();
    desk.touch_row("name jaw");
    desk.click("Type a value##type jaw");
  };
  open();
  for (const char* key : {"0##pad", ".##pad", "5##pad"}) desk.click(key);
  desk.click("Set##number");
  EXPECT_DOUBLE_EQ(desk.document().pose[jaw()], 0.5);
  open();
  desk.click("Most 1###field2");
  desk.click("2##pad");
  desk.click("Set##number");
  EXPECT_DOUBLE_EQ(desk.document().model->rig->parameters()[jaw()].maximum, 2);
  EXPECT_DOUBLE_EQ(desk.document().pose[jaw()], 0.5) << "the value stays";
  open();
  desk.click("-##pad");
  desk.click("Set##number");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::number) << "what is no number is told";
  EXPECT_TRUE(desk.app->of<Notices>().all().back().is_error);
  desk.click("Rest##number");
  EXPECT_DOUBLE_EQ(desk.document().pose[jaw()], 0);
}

TEST(AppEditing, AKeyIsNamedDraggedAndKeepsItsNameWhenItIsKeyedAnew) {
  Desk desk("keys");
  desk.begin();
  desk.click("Key");
  desk.click("More##more of time");
  desk.click("Name##key");
  desk.click("##key name");
  desk.click("key s");
  desk.click("key m");
  desk.click("Name it");
  ASSERT_EQ(desk.document().timeline->keys.front().name, "sm");
  desk.app->of<Controls>().set_parameter(0, desk.document().model->rig->parameters()[0].maximum);
  desk.click("Key");
  EXPECT_EQ(desk.document().timeline->keys.front().name, "sm");
  const auto pose = desk.document().pose;
  const Area track = *desk.interface->find("track");
  const auto at = [&](double share) { return PxPoint{track.left + share * track.width(), track.middle().y}; };
  desk.app->of<Pointer>().moved(at(0.01));
  desk.app->of<Pointer>().button(MouseButton::left, true, at(0.01));
  desk.frames();
  for (const double share : {0.1, 0.3, 0.5}) {
    desk.app->of<Pointer>().moved(at(share));
    desk.frames(2);
  }
  EXPECT_EQ(desk.document().timeline->keys.front().time_s, 0) << "it moves when it is let go";
  desk.app->of<Pointer>().button(MouseButton::left, false, at(0.5));
  desk.frames();
  ASSERT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_NEAR(desk.document().timeline->keys.front().time_s, 2, 0.1);
  EXPECT_EQ(desk.document().timeline->keys.front().name, "sm");
  EXPECT_EQ(desk.document().pose, pose);
  // Nearer and farther.
  const double all = desk.app->of<PanelState>().own.of<TimelineShown>().span_s;
  desk.click("More##more of time");
  desk.click("Zoom in##track");
  EXPECT_GT(desk.app->of<PanelState>().own.of<TimelineShown>().span_s, all);
  const double from = desk.app->of<PanelState>().own.of<TimelineShown>().from_s;
  desk.click("More##more of time");
  desk.click("Back##track");
  EXPECT_LT(desk.app->of<PanelState>().own.of<TimelineShown>().from_s, from);
  for (int i = 0; i < 2; ++i) {
    desk.click("More##more of time");
    desk.click("On##track");
  }
  EXPECT_GT(desk.app->of<PanelState>().own.of<TimelineShown>().from_s, from) << "also away from the cursor";
  desk.click("More##more of time");
  desk.click("Zoom out##track");
  EXPECT_EQ(desk.app->of<PanelState>().own.of<TimelineShown>().span_s, 0);
}

TEST(AppEditing, ASessionPlayedInAWindowOfAnotherSizeEndsInTheSameState) {
  document::DocumentState state;
  {
    Desk desk("played", "builtin:demo");
    desk.begin();
    desk.click("Rig");
    const PxPoint middle = lasso_chin(desk);
    desk.stroke({middle + PxPoint{-26, 18}, middle + PxPoint{0, 26}, middle + PxPoint{26, 18}});
    desk.click("Pose");
    pose_mouth(desk);
    desk.click("Select");
    const auto line = desk.document().curves.front()->target->line;
    desk.stroke({line[10], line[10] + PxPoint{0, 18}});
    desk.click("Key");
    state = desk.app->of<EditingSession>().state();
    std::filesystem::copy_file(desk.app->of<Recording>().path(), desk.path("recorded.session"));
  }
  Desk desk("played", "builtin:demo", false);
  if (desk.app->of<Dialogs>().open() == Dialog::recover) desk.click("Start fresh");
  desk.app->of<Pointer>().resized({900, 1000}, 96);
  desk.frames();
  ASSERT_TRUE(desk.app->of<Files>().play_trace(desk.path("recorded.session")).ok());
  desk.app->of<Player>().trace->set_speed(16);
  for (int i = 0; i < 2000 && !desk.app->of<Player>().trace->finished(); ++i) desk.frames(1);
  ASSERT_TRUE(desk.app->of<Player>().trace->finished());
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().view().viewport.width, 1280) << "as it was drawn";
  desk.frames(2);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().view().viewport.width, 900) << "one goes on in this window";
}

TEST(AppEditing, ACurveThatIsTouchedIsKeptOrDeletedWithThePenAlone) {
  Desk desk("curve-menu");
  desk.begin();
  pose_mouth(desk);
  desk.click("Select");
  const auto touch = [&] {
    const auto& curve = *desk.document().curves.front();
    const auto camera =
        geometry::Camera::make(desk.app->of<Canvas>().view().camera, desk.app->of<Canvas>().view().viewport);
    const PxPoint at = *camera->project(geometry::ModelPoint(desk.app->of<Canvas>().surface().at(curve.points[5])));
    desk.stroke({at, at + PxPoint{1, 0}});
  };
  touch();
  desk.click("Keep##curve");
  EXPECT_EQ(desk.document().curves.front()->role, document::PoseCurveRole::constraint);
  touch();
  desk.click("Delete##curve");
  EXPECT_TRUE(desk.document().curves.empty());
  desk.click("Pressure");
  EXPECT_TRUE(desk.document().pressure_weighting);
}

}  // namespace
}  // namespace penpose::app
