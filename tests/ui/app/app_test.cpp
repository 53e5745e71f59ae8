#include "ui/app/app.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

#include "replay/session/session_player.h"
#include "tests/support/app_desk.h"
#include "tests/support/app_replay.h"
#include "ui/files/load_model.h"
#include "ui/files/trace_file.h"

namespace penpose::app {
namespace {

TEST(App, ANewUserSketchesPosesKeysSavesQuitsAndFindsEverythingAgain) {
  document::DocumentState saved;
  std::size_t deformers = 0;
  std::string session;
  {
    Desk desk("whole", "builtin:demo");
    desk.begin();
    EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
    // Sketch one control around the chin.
    deformers = desk.document().model->deformers->size();
    sketch_chin(desk);
    ASSERT_EQ(desk.document().model->deformers->size(), deformers + 1) << desk.app->of<Notices>().all().back().text;
    EXPECT_FALSE(desk.document().pending);
    EXPECT_EQ(desk.app->of<Controls>().selected(), desk.document().model->deformers->deformers().back()->sketch().name)
        << "the new control is shown";
    // Pose the mouth and key it.
    desk.click("Pose");
    const auto rest = desk.document().pose;
    pose_mouth(desk);
    ASSERT_EQ(desk.document().curves.size(), 1U);
    EXPECT_TRUE(desk.document().curves.front()->target.has_value());
    EXPECT_NE(desk.document().pose, rest) << "the face followed";
    EXPECT_FALSE(desk.app->of<EditingSession>().last_stroke().movements().empty());
    desk.click("Key");
    ASSERT_EQ(desk.document().timeline->keys.size(), 1U);
    EXPECT_EQ(desk.document().timeline->keys.front().pose, desk.document().pose);
    // Save under the name that is offered, and quit.
    EXPECT_TRUE(desk.app->of<EditingSession>().unsaved());
    desk.press('s', true);
    desk.click("Save##now");
    EXPECT_FALSE(desk.app->of<EditingSession>().unsaved());
    EXPECT_EQ(desk.app->of<Files>().project(), desk.path("head.glb"));
    saved = desk.app->of<EditingSession>().state();
    session = desk.app->of<Recording>().path();
    desk.app->of<Leaving>().ask_to_quit();
    EXPECT_TRUE(desk.app->of<Leaving>().wants_quit());
  }
  auto again = files::load_document((Desk::folder_of("whole") / "head.glb").string());
  ASSERT_TRUE(again.ok());
  document::DocumentHasher hasher;
  EXPECT_EQ(hasher(*again), saved) << "what was saved opens as it was";
  // The session of it replays to the same document.
  const auto played = replayed(session);
  ASSERT_TRUE(played.ok());
  EXPECT_EQ(played->differing, 0U);
  EXPECT_GT(played->checked, 5U);
  EXPECT_EQ(played->session->editor().state(), saved);
}

TEST(App, TheFaceFollowsThePenBeforeItLiftsAndTheDocumentChangesOnlyThen) {
  Desk desk("follow");
  desk.begin();
  const std::string curve = "brow_L";
  desk.stroke(desk.named_curve(curve));
  const auto before = desk.app->of<EditingSession>().state();
  const rig::Pose rest = desk.document().pose;
  desk.stroke(desk.named_curve(curve, {0, -18}), false);
  EXPECT_NE(desk.app->of<EditingSession>().shown().pose(), rest);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), before);
  desk.app->of<Pointer>().button(MouseButton::left, false, {400, 400});
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
  EXPECT_NE(desk.document().pose, rest);
  desk.press('z', true);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), before);
  desk.press('z', true, true);
  EXPECT_NE(desk.app->of<EditingSession>().state(), before);
}

TEST(App, StrokesOnPanelsNeverDraw) {
  Desk desk("panels");
  desk.begin();
  const auto before = desk.app->of<EditingSession>().state();
  desk.stroke({{1100, 200}, {700, 300}, {500, 300}});
  desk.stroke({{20, 200}, {300, 300}});
  EXPECT_EQ(desk.document().curves.size(), 0U);
  EXPECT_EQ(desk.app->of<EditingSession>().state().parts[3], before.parts[3]);
}

TEST(App, ASliderIsOneCommandHoweverFarItWasDragged) {
  Desk desk("slider");
  desk.begin();
  const std::string name = desk.document().model->rig->parameters()[0].name;
  const Area area = *desk.interface->find("slider " + name);
  const std::size_t undo = desk.app->of<EditingSession>().editor().history().undo_count();
  desk.app->of<Pointer>().moved(area.middle());
  desk.app->of<Pointer>().button(MouseButton::left, true, area.middle());
  desk.frames();
  for (int i = 1; i <= 10; ++i) {
    desk.app->of<Pointer>().moved(area.middle() + PxPoint{6.0 * i, 0});
    desk.frames(1);
  }
  EXPECT_TRUE(desk.app->of<EditingSession>().shown().previews());
  EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), undo);
  const double shown = desk.app->of<EditingSession>().shown().pose()[0];
  desk.app->of<Pointer>().button(MouseButton::left, false, area.middle() + PxPoint{60, 0});
  desk.frames();
  EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), undo + 1);
  EXPECT_DOUBLE_EQ(desk.document().pose[0], shown);
  EXPECT_FALSE(desk.app->of<EditingSession>().shown().previews());
}

TEST(App, ALockedParameterIsNotMovedByAStroke) {
  Desk desk("lock");
  desk.begin();
  const std::string moved = moved_with_mouth(desk);
  desk.press('z', true);
  desk.press('z', true);
  desk.app->of<EditingSession>().perform(document::LockParameters{{moved}, true});
  const auto index = *rig::find_parameter(desk.document().model->rig->parameters(), moved);
  const double before = desk.document().pose[index];
  pose_mouth(desk);
  EXPECT_DOUBLE_EQ(desk.document().pose[index], before);
}

TEST(App, NotThisOneSolvesTheStrokeAgainAndGivingItBackToo) {
  Desk desk("not_this_one");
  desk.begin();
  const std::string moved = moved_with_mouth(desk);
  const auto index = *rig::find_parameter(desk.document().model->rig->parameters(), moved);
  const rig::Pose meant = desk.document().pose;
  lock_parameters(desk.app->of<EditingSession>(), {moved}, true);
  EXPECT_DOUBLE_EQ(desk.document().pose[index], desk.document().model->rig->parameters()[index].rest);
  lock_parameters(desk.app->of<EditingSession>(), {moved}, false);
  for (std::size_t i = 0; i < meant.size(); ++i)
    EXPECT_NEAR(desk.document().pose[i], meant[i], 0.01) << "targets keep 64 points of a line";
}

TEST(App, ATargetWhereItsCurveIsMovesNothingAndSaysSo) {
  Desk desk("still");
  desk.begin();
  const geometry::PxPoint middle = desk.app->of<Canvas>().free_area().middle();
  const auto line = [&] {
    desk.stroke(
        {middle + geometry::PxPoint{-60, 20}, middle + geometry::PxPoint{0, 24}, middle + geometry::PxPoint{60, 20}});
  };
  line();
  ASSERT_EQ(desk.document().curves.size(), 1U);
  EXPECT_FALSE(desk.app->of<EditingSession>().last_stroke().is_newest());
  const rig::Pose before = desk.document().pose;
  line();
  EXPECT_EQ(desk.document().pose, before);
  EXPECT_TRUE(desk.app->of<EditingSession>().last_stroke().is_newest());
  EXPECT_TRUE(desk.app->of<EditingSession>().last_stroke().movements().empty());
  EXPECT_LT(desk.app->of<EditingSession>().last_stroke().left_px(), 4);
}

TEST(App, ScrubbingShowsAndLettingGoTakesThePose) {
  Desk desk("scrub");
  desk.begin();
  desk.click("Key");
  desk.app->of<Controls>().set_parameter(0, desk.document().model->rig->parameters()[0].maximum);
  desk.app->of<Playback>().scrub(2);
  desk.app->of<Playback>().end_scrub();
  desk.app->of<Controls>().set_parameter(0, desk.document().model->rig->parameters()[0].maximum);
  desk.click("Key");
  ASSERT_EQ(desk.document().timeline->keys.size(), 2U);
  const auto state = desk.app->of<EditingSession>().state();
  desk.app->of<Playback>().scrub(1);
  EXPECT_NE(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
  desk.app->of<Playback>().end_scrub();
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), desk.document().pose);
  const double middle = desk.document().pose[0];
  EXPECT_GT(middle, 0);
  EXPECT_LT(middle, desk.document().model->rig->parameters()[0].maximum);
  // Playing goes round and changes nothing but what is shown.
  desk.press(' ');
  EXPECT_TRUE(desk.app->of<Playback>().playing());
  desk.frames(200);
  EXPECT_EQ(desk.document().pose[0], middle);
  desk.press(' ');
  EXPECT_FALSE(desk.app->of<Playback>().playing());
}

TEST(App, APoseThatIsNotKeyedYetIsCarriedAlongTheTimeline) {
  Desk desk("carried");
  desk.begin();
  desk.click("Key");
  pose_mouth(desk);
  const auto pose = desk.document().pose;
  const Area track = *desk.interface->find("track");
  const PxPoint at{track.left + 0.5 * track.width(), track.middle().y};
  desk.app->of<Pointer>().moved(at);
  desk.app->of<Pointer>().button(MouseButton::left, true, at);
  desk.frames();
  desk.app->of<Pointer>().button(MouseButton::left, false, at);
  desk.frames();
  EXPECT_GT(desk.app->of<Playback>().time_s(), 1);
  EXPECT_EQ(desk.document().pose, pose);
  desk.click("Key");
  ASSERT_EQ(desk.document().timeline->keys.size(), 2U);
  EXPECT_EQ(desk.document().timeline->keys.back().pose, pose);
  desk.press(',');
  EXPECT_EQ(desk.app->of<Playback>().time_s(), 0);
  EXPECT_NE(desk.document().pose, pose);
}

TEST(App, ATargetIsDraggedWithTheToolSelectAndTheFaceFollows) {
  Desk desk("drag");
  desk.begin();
  pose_mouth(desk);
  const auto id = desk.document().curves.front()->id;
  const auto before = desk.document().curves.front()->target->line;
  const auto pose = desk.document().pose;
  desk.click("Select");
  const PxPoint from = before[before.size() / 2];
  desk.stroke({from, from + PxPoint{0, 25}});
  ASSERT_EQ(desk.document().curves.front()->id, id);
  const auto after = desk.document().curves.front()->target->line;
  EXPECT_NEAR(after.front().y - before.front().y, 25, 0.1);
  EXPECT_NE(desk.document().pose, pose);
}

TEST(App, TouchingTheFaceWithTheToolSelectPicksTheControlThatMovesItMost) {
  Desk desk("pick");
  desk.begin();
  desk.click("Select");
  const auto brow = desk.named_curve("brow_L");
  desk.stroke({brow.front(), brow.front() + PxPoint{1, 0}});
  EXPECT_EQ(desk.app->of<Controls>().selected().substr(0, 4), "brow");
  EXPECT_TRUE(desk.document().curves.empty());
}

TEST(App, OpeningAFileThatIsNoneSaysSoAndKeepsTheWork) {
  Desk desk("broken");
  desk.begin();
  std::ofstream(desk.path("broken.glb")) << "not a glb";
  pose_mouth(desk);
  const auto state = desk.app->of<EditingSession>().state();
  desk.app->of<Files>().try_open(desk.path("broken.glb"));
  EXPECT_TRUE(desk.app->of<Notices>().all().back().is_error);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
}

TEST(App, ASessionWithoutWorkLeavesNoFileBehind) {
  std::string session;
  {
    Desk desk("empty");
    session = desk.app->of<Recording>().path();
    EXPECT_TRUE(std::filesystem::exists(session));
  }
  EXPECT_FALSE(std::filesystem::exists(session));
  EXPECT_FALSE(std::filesystem::exists(session + ".open"));
}

}  // namespace
}  // namespace penpose::app
