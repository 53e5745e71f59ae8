#include "ui/app/app.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

#include "replay/session_player.h"
#include "tests/support/app_desk.h"
#include "ui/cli/load_model.h"
#include "ui/cli/trace_file.h"

namespace penpose::app {
namespace {

std::vector<PxPoint> around(PxPoint middle, double x, double y) {
  std::vector<PxPoint> line;
  for (int i = 0; i <= 24; ++i) {
    const double t = 2 * 3.14159265 * i / 24;
    line.push_back({middle.x + x * std::cos(t), middle.y + y * std::sin(t)});
  }
  return line;
}

/// The first curve of the model, wide enough for a stroke.
std::string any_curve(const Desk& desk) {
  for (const auto& curve : desk.document().model->curves) {
    if (curve.name.find("mouth") != std::string::npos || curve.name.find("lip") != std::string::npos) return curve.name;
  }
  return desk.document().model->curves.front().name;
}

/// Draws along the mouth and then where it should go.
void pose_mouth(Desk& desk) {
  const std::string curve = any_curve(desk);
  const auto reference = desk.named_curve(curve);
  const auto target = desk.named_curve(curve, {0, -14});
  desk.stroke(reference);
  desk.stroke(target);
}

TEST(App, ANewUserSketchesPosesKeysSavesQuitsAndFindsEverythingAgain) {
  document::DocumentState saved;
  std::size_t deformers = 0;
  std::string session;
  {
    Desk desk("whole", "builtin:demo");
    desk.begin();
    EXPECT_EQ(desk.app->panels().dialog, Dialog::none);
    // Sketch one control around the chin.
    deformers = desk.document().model->deformers->size();
    desk.click("Rig");
    const auto mouth = desk.named_curve(any_curve(desk));
    const PxPoint middle = mouth[mouth.size() / 2] + PxPoint{0, 55};
    desk.stroke(around(middle, 60, 32));
    desk.stroke(around(middle, 28, 14));
    desk.stroke({middle + PxPoint{-26, 18}, middle + PxPoint{0, 26}, middle + PxPoint{26, 18}});
    ASSERT_EQ(desk.document().model->deformers->size(), deformers + 1) << desk.app->notices().back().text;
    EXPECT_FALSE(desk.document().pending);
    EXPECT_EQ(desk.app->panels().deformer, desk.document().model->deformers->deformers().back()->sketch().name)
        << "the new control is shown";
    // Pose the mouth and key it.
    desk.click("Pose");
    const auto rest = desk.document().pose;
    pose_mouth(desk);
    ASSERT_EQ(desk.document().curves.size(), 1U);
    EXPECT_TRUE(desk.document().curves.front()->target.has_value());
    EXPECT_NE(desk.document().pose, rest) << "the face followed";
    EXPECT_FALSE(desk.app->workspace().movements().empty());
    desk.click("Key");
    ASSERT_EQ(desk.document().timeline->keys.size(), 1U);
    EXPECT_EQ(desk.document().timeline->keys.front().pose, desk.document().pose);
    // Save under the name that is offered, and quit.
    EXPECT_TRUE(desk.app->workspace().unsaved());
    desk.press('s', true);
    desk.click("Save##now");
    EXPECT_FALSE(desk.app->workspace().unsaved());
    EXPECT_EQ(desk.app->project(), desk.path("head.glb"));
    saved = desk.app->workspace().state();
    session = desk.app->session_path();
    desk.app->ask_to_quit();
    EXPECT_TRUE(desk.app->wants_quit());
  }
  auto again = cli::load_document((Desk::folder_of("whole") / "head.glb").string());
  ASSERT_TRUE(again.ok());
  document::DocumentHasher hasher;
  EXPECT_EQ(hasher(*again), saved) << "what was saved opens as it was";
  // The session of it replays to the same document.
  const auto file = cli::open_trace(session);
  ASSERT_TRUE(file.ok()) << file.error().line(session);
  replay::PlayerOptions options;
  options.open = [](const std::string& path) { return cli::load_document(path); };
  const auto played = replay::play_session(cli::read_from_file(file->get()), options);
  ASSERT_TRUE(played.ok());
  EXPECT_EQ(played->differing, 0U);
  EXPECT_GT(played->checked, 5U);
  EXPECT_EQ(played->session->editor().state(), saved);
}

TEST(App, TheFaceFollowsThePenBeforeItLiftsAndTheDocumentChangesOnlyThen) {
  Desk desk("follow");
  desk.begin();
  const std::string curve = any_curve(desk);
  desk.stroke(desk.named_curve(curve));
  const auto before = desk.app->workspace().state();
  const rig::Pose rest = desk.document().pose;
  desk.stroke(desk.named_curve(curve, {0, 18}), false);
  EXPECT_NE(desk.app->workspace().shown_pose(), rest);
  EXPECT_EQ(desk.app->workspace().state(), before);
  desk.app->mouse_button(MouseButton::left, false, {400, 400});
  EXPECT_EQ(desk.app->workspace().shown_pose(), desk.document().pose);
  EXPECT_NE(desk.document().pose, rest);
  desk.press('z', true);
  EXPECT_EQ(desk.app->workspace().state(), before);
  desk.press('z', true, true);
  EXPECT_NE(desk.app->workspace().state(), before);
}

TEST(App, StrokesOnPanelsNeverDraw) {
  Desk desk("panels");
  desk.begin();
  const auto before = desk.app->workspace().state();
  desk.stroke({{1100, 200}, {700, 300}, {500, 300}});
  desk.stroke({{20, 200}, {300, 300}});
  EXPECT_EQ(desk.document().curves.size(), 0U);
  EXPECT_EQ(desk.app->workspace().state().parts[3], before.parts[3]);
}

TEST(App, ASliderIsOneCommandHoweverFarItWasDragged) {
  Desk desk("slider");
  desk.begin();
  const std::string name = desk.document().model->rig->parameters()[0].name;
  const Area area = *desk.interface->find("slider " + name);
  const std::size_t undo = desk.app->workspace().editor().history().undo_count();
  desk.app->mouse_moved(area.middle());
  desk.app->mouse_button(MouseButton::left, true, area.middle());
  desk.frames();
  for (int i = 1; i <= 10; ++i) {
    desk.app->mouse_moved(area.middle() + PxPoint{6.0 * i, 0});
    desk.frames(1);
  }
  EXPECT_TRUE(desk.app->workspace().previews());
  EXPECT_EQ(desk.app->workspace().editor().history().undo_count(), undo);
  const double shown = desk.app->workspace().shown_pose()[0];
  desk.app->mouse_button(MouseButton::left, false, area.middle() + PxPoint{60, 0});
  desk.frames();
  EXPECT_EQ(desk.app->workspace().editor().history().undo_count(), undo + 1);
  EXPECT_DOUBLE_EQ(desk.document().pose[0], shown);
  EXPECT_FALSE(desk.app->workspace().previews());
}

TEST(App, ALockedParameterIsNotMovedByAStroke) {
  Desk desk("lock");
  desk.begin();
  pose_mouth(desk);
  ASSERT_FALSE(desk.app->workspace().movements().empty());
  const std::string moved = desk.app->workspace().movements().front().name;
  desk.press('z', true);
  desk.press('z', true);
  desk.app->workspace().perform(document::LockParameters{{moved}, true});
  const auto index = *rig::find_parameter(desk.document().model->rig->parameters(), moved);
  const double before = desk.document().pose[index];
  pose_mouth(desk);
  EXPECT_DOUBLE_EQ(desk.document().pose[index], before);
}

TEST(App, ScrubbingShowsAndLettingGoTakesThePose) {
  Desk desk("scrub");
  desk.begin();
  desk.click("Key");
  desk.app->set_parameter(0, desk.document().model->rig->parameters()[0].maximum);
  desk.app->scrub(2);
  desk.app->end_scrub();
  desk.app->set_parameter(0, desk.document().model->rig->parameters()[0].maximum);
  desk.click("Key");
  ASSERT_EQ(desk.document().timeline->keys.size(), 2U);
  const auto state = desk.app->workspace().state();
  desk.app->scrub(1);
  EXPECT_NE(desk.app->workspace().shown_pose(), desk.document().pose);
  EXPECT_EQ(desk.app->workspace().state(), state);
  desk.app->end_scrub();
  EXPECT_EQ(desk.app->workspace().shown_pose(), desk.document().pose);
  const double middle = desk.document().pose[0];
  EXPECT_GT(middle, 0);
  EXPECT_LT(middle, desk.document().model->rig->parameters()[0].maximum);
  // Playing goes round and changes nothing but what is shown.
  desk.press(' ');
  EXPECT_TRUE(desk.app->playing());
  desk.frames(200);
  EXPECT_EQ(desk.document().pose[0], middle);
  desk.press(' ');
  EXPECT_FALSE(desk.app->playing());
}

TEST(App, APoseThatIsNotKeyedYetIsCarriedAlongTheTimeline) {
  Desk desk("carried");
  desk.begin();
  desk.click("Key");
  pose_mouth(desk);
  const auto pose = desk.document().pose;
  const Area track = *desk.interface->find("track");
  const PxPoint at{track.left + 0.5 * track.width(), track.middle().y};
  desk.app->mouse_moved(at);
  desk.app->mouse_button(MouseButton::left, true, at);
  desk.frames();
  desk.app->mouse_button(MouseButton::left, false, at);
  desk.frames();
  EXPECT_GT(desk.app->panels().time_s, 1);
  EXPECT_EQ(desk.document().pose, pose);
  desk.click("Key");
  ASSERT_EQ(desk.document().timeline->keys.size(), 2U);
  EXPECT_EQ(desk.document().timeline->keys.back().pose, pose);
  desk.press(',');
  EXPECT_EQ(desk.app->panels().time_s, 0);
  EXPECT_NE(desk.document().pose, pose);
}

TEST(App, AfterACrashTheWorkIsOfferedAndComesBack) {
  document::DocumentState lost;
  {
    auto* desk = new Desk("crash");
    desk->begin();
    pose_mouth(*desk);
    lost = desk->app->workspace().state();
    // A crash: nothing is finished. The kernel gives the lock back, as it does for a program that died.
    const std::string lock = desk->app->session_path() + ".open";
    const std::string copy = desk->path("state/sessions/2026-01-01_00-00-00.session");
    std::filesystem::copy_file(desk->app->session_path(), copy);
    std::ofstream(copy + ".open") << "";
    delete desk;
  }
  Desk desk("crash", "builtin:demo", false);
  ASSERT_EQ(desk.app->panels().dialog, Dialog::recover);
  desk.click("Bring it back");
  EXPECT_EQ(desk.app->workspace().state().parts[2], lost.parts[2]) << "the pose is back";
  EXPECT_EQ(desk.app->workspace().state().parts[3], lost.parts[3]) << "the curves are back";
  EXPECT_TRUE(abandoned_sessions(desk.path("state/sessions")).empty()) << "it is not offered again";
}

TEST(App, UnpluggingInTheMiddleOfAStrokeEndsItAndSaysSo) {
  Desk desk("unplug");
  desk.begin();
  auto identity = replay::virtual_pen_identity();
  identity.name = "Test Tablet";
  desk.app->tablet_arrived(1, identity);
  const auto line = desk.named_curve(any_curve(desk));
  const auto viewport = desk.app->workspace().editor().view().viewport;
  for (const PxPoint& at : line) {
    desk.now_us += 3333;
    desk.app->tablet_report(1, desk.now_us, replay::virtual_pen_report({at, 0.7, true, true, false, false}, viewport));
  }
  EXPECT_EQ(desk.document().curves.size(), 0U);
  desk.app->tablet_left(1, "Test Tablet");
  EXPECT_EQ(desk.document().curves.size(), 1U) << "what was drawn is kept";
  EXPECT_EQ(desk.app->notices().back().text, "Test Tablet was unplugged");
  // It comes back under its number and goes on.
  desk.app->tablet_arrived(1, identity);
  for (const PxPoint& at : desk.named_curve(any_curve(desk), {0, 12})) {
    desk.now_us += 3333;
    desk.app->tablet_report(1, desk.now_us, replay::virtual_pen_report({at, 0.7, true, true, false, false}, viewport));
  }
  desk.app->tablet_report(1, desk.now_us, replay::virtual_pen_report({{0, 0}, 0, true, false, false, false}, viewport));
  ASSERT_EQ(desk.document().curves.size(), 1U);
  EXPECT_TRUE(desk.document().curves.front()->target.has_value());
}

TEST(App, WhileATabletsPenIsNearTheDesktopsOwnPointerIsIgnored) {
  Desk desk("near");
  desk.begin();
  desk.app->tablet_arrived(1, replay::virtual_pen_identity());
  const auto viewport = desk.app->workspace().editor().view().viewport;
  desk.app->tablet_report(1, desk.now_us,
                          replay::virtual_pen_report({{400, 300}, 0, true, false, false, false}, viewport));
  desk.stroke(desk.named_curve(any_curve(desk)));
  // The stroke above took longer than a pen stays near without a report; its press came while it was near.
  EXPECT_EQ(desk.document().curves.size(), 0U);
  desk.now_us += 1'000'000;
  desk.frames();
  desk.stroke(desk.named_curve(any_curve(desk)));
  EXPECT_EQ(desk.document().curves.size(), 1U);
}

TEST(App, ATabletsPenPressesButtonsToo) {
  Desk desk("tablet-buttons");
  desk.begin();
  desk.app->tablet_arrived(1, replay::virtual_pen_identity());
  const auto viewport = desk.app->workspace().editor().view().viewport;
  const PxPoint key = desk.interface->find("Key")->middle();
  const auto send = [&](bool tip) {
    desk.now_us += 3000;
    desk.app->tablet_report(1, desk.now_us, replay::virtual_pen_report({key, 0.5, true, tip, false, false}, viewport));
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

TEST(App, TheBarrelButtonTurnsTheViewAndAClickOpensTheMenuAroundThePen) {
  Desk desk("barrel");
  desk.begin();
  const auto before = desk.app->view();
  desk.app->mouse_button(MouseButton::right, true, {500, 400});
  desk.app->mouse_moved({560, 400});
  desk.app->mouse_button(MouseButton::right, false, {560, 400});
  EXPECT_FALSE(desk.app->view() == before);
  EXPECT_FALSE(desk.app->panels().radial.has_value());
  desk.app->mouse_button(MouseButton::right, true, {500, 400});
  desk.app->mouse_button(MouseButton::right, false, {500, 400});
  desk.frames();
  ASSERT_TRUE(desk.app->panels().radial.has_value());
  desk.click("Erase##radial");
  EXPECT_EQ(desk.app->workspace().editor().tool().kind, drawing::ToolKind::erase);
  EXPECT_FALSE(desk.app->panels().radial.has_value());
}

TEST(App, ATraceInPlaceOfATabletDrawsTheSame) {
  Desk desk("trace");
  desk.begin();
  // A trace of a reference and a target, written as a tablet's.
  replay::TraceWriter writer;
  writer.declare(0, replay::virtual_pen_device());
  std::int64_t time = 0;
  const auto viewport = desk.app->workspace().editor().view().viewport;
  for (const PxPoint by : {PxPoint{0, 0}, PxPoint{0, -12}}) {
    for (const PxPoint& at : desk.named_curve(any_curve(desk), by)) {
      writer.report(0, time += 3333, replay::virtual_pen_report({at, 0.6, true, true, false, false}, viewport));
    }
    writer.report(0, time += 3333, replay::virtual_pen_report({{500, 500}, 0, true, false, false, false}, viewport));
  }
  std::ofstream(desk.path("pen.hid")) << writer.take();
  ASSERT_TRUE(desk.app->play_trace(desk.path("pen.hid")).ok());
  desk.frames(200);
  EXPECT_TRUE(desk.app->player()->finished());
  ASSERT_EQ(desk.document().curves.size(), 1U);
  EXPECT_TRUE(desk.document().curves.front()->target.has_value());
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

TEST(App, TheFaceFollowsATargetThatIsDraggedOrDrawnOverBeforeThePenLifts) {
  Desk desk("held");
  desk.begin();
  pose_mouth(desk);
  const auto id = desk.document().curves.front()->id;
  const auto state = desk.app->workspace().state();
  const auto settled = desk.document().pose;
  const auto line = desk.document().curves.front()->target->line;
  desk.click("Select");
  const PxPoint from = line[line.size() / 2];
  desk.stroke({from, from + PxPoint{0, 25}}, false);
  EXPECT_NE(desk.app->workspace().shown_pose(), settled) << "it follows";
  EXPECT_EQ(desk.app->workspace().state(), state) << "it is no command yet";
  const auto shown = desk.app->workspace().shown_pose();
  desk.app->mouse_button(MouseButton::left, false, from + PxPoint{0, 25});
  double apart = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) apart = std::max(apart, std::abs(shown[i] - desk.document().pose[i]));
  EXPECT_LT(apart, 0.3) << "what was shown is about what came of it";
  // From another view the target is moved as it is seen there.
  desk.click("3/4");
  const auto camera = geometry::Camera::make(desk.app->view().camera, desk.app->view().viewport);
  const auto& target = *desk.document().curves.front()->target;
  const PxPoint seen = *camera->project(target.points[target.points.size() / 2]);
  desk.stroke({seen, seen + PxPoint{0, -20}});
  ASSERT_EQ(desk.document().curves.front()->id, id);
  const auto& moved = *desk.document().curves.front()->target;
  EXPECT_NEAR(camera->project(moved.points[moved.points.size() / 2])->y, seen.y - 20, 4);
  // Redrawing a part.
  desk.click("Front");
  desk.click("Redraw");
  const auto before = desk.app->workspace().state();
  const auto now = desk.named_curve(any_curve(desk), {0, 10});
  desk.stroke({now[now.size() / 3], now[now.size() / 2], now[2 * now.size() / 3]}, false);
  EXPECT_TRUE(desk.app->workspace().live().active());
  EXPECT_EQ(desk.app->workspace().state(), before);
  desk.app->mouse_button(MouseButton::left, false, now[2 * now.size() / 3]);
  EXPECT_NE(desk.app->workspace().state(), before);
}

/// The two lassos of a control below the mouth.
PxPoint lasso_chin(Desk& desk) {
  const auto mouth = desk.named_curve(any_curve(desk));
  const PxPoint middle = mouth[mouth.size() / 2] + PxPoint{0, 55};
  desk.stroke(around(middle, 60, 32));
  desk.stroke(around(middle, 28, 14));
  return middle;
}

TEST(App, AControlsFeatureModeAndSurfaceAreChosenBeforeAndWhileItIsMade) {
  Desk desk("choices");
  desk.begin();
  desk.click("Rig");
  desk.click("Turn");
  EXPECT_EQ(desk.document().pending->sketch.mode, articulation::Mode::rotate);
  const PxPoint middle = lasso_chin(desk);
  ASSERT_TRUE(desk.document().pending);
  // The feature that was found is shown, from wherever one looks.
  EXPECT_GT(desk.app->workspace().sketch().reference().size(), 10U);
  const auto shows_feature = [&] {
    const auto& curves = desk.app->curves();
    return std::any_of(curves.begin(), curves.end(), [](const auto& curve) {
      return curve.kind == render::CurveKind::reference && curve.points.size() > 10;
    });
  };
  EXPECT_TRUE(shows_feature());
  // It is drawn by hand in its place, and then found again.
  desk.click("Draw the feature myself");
  EXPECT_NE(desk.app->hint().find("3 of 4"), std::string::npos);
  desk.stroke({middle + PxPoint{-20, 4}, middle + PxPoint{20, 4}});
  EXPECT_FALSE(desk.document().pending->sketch.reference.empty());
  EXPECT_TRUE(shows_feature());
  desk.click("Find the feature by itself");
  EXPECT_TRUE(desk.document().pending->sketch.reference.empty());
  // Mode and surface of what is half made; its strokes stay.
  desk.click("Slide");
  EXPECT_EQ(desk.document().pending->sketch.mode, articulation::Mode::translate);
  EXPECT_FALSE(desk.document().pending->sketch.specific.empty());
  desk.click("Over: nothing##surface");
  desk.click("a ball");
  ASSERT_TRUE(std::holds_alternative<articulation::Sphere>(desk.document().pending->sketch.surface));
  EXPECT_FALSE(desk.document().pending->sketch.specific.empty());
  // It plays to and fro while the goal is drawn.
  desk.click("Swing");
  desk.stroke({middle + PxPoint{-26, 18}, middle + PxPoint{0, 26}, middle + PxPoint{26, 18}}, false);
  desk.frames(3);
  const auto first = desk.app->workspace().shown_pose();
  desk.frames(20);
  EXPECT_NE(desk.app->workspace().shown_pose(), first);
  desk.app->mouse_button(MouseButton::left, false, middle + PxPoint{26, 18});
  desk.frames();
  ASSERT_FALSE(desk.document().pending) << desk.app->notices().back().text;
  const auto& made = desk.document().model->deformers->deformers().back();
  EXPECT_EQ(made->mode(), articulation::Mode::translate);
  EXPECT_TRUE(std::holds_alternative<articulation::Sphere>(made->sketch().surface));
  desk.click("Swing");
  EXPECT_FALSE(desk.app->panels().swing);
}

TEST(App, AControlIsDrawnAgainAndTheFaceShowsItWhileItIsDrawn) {
  Desk desk("again");
  desk.begin();
  desk.click("Rig");
  const PxPoint middle = lasso_chin(desk);
  desk.stroke({middle + PxPoint{-26, 18}, middle + PxPoint{0, 26}, middle + PxPoint{26, 18}});
  const auto count = desk.document().model->deformers->deformers().size();
  const auto made = desk.document().model->deformers->deformers().back();
  desk.click("Goal");
  const auto rest = desk.app->workspace().shown_pose();
  desk.stroke({middle + PxPoint{-26, 38}, middle + PxPoint{0, 46}, middle + PxPoint{26, 38}}, false);
  EXPECT_NE(desk.app->workspace().shown_pose(), rest);
  EXPECT_EQ(desk.document().model->deformers->deformers().back(), made);
  desk.app->mouse_button(MouseButton::left, false, middle + PxPoint{26, 38});
  desk.frames();
  ASSERT_EQ(desk.document().model->deformers->deformers().size(), count);
  EXPECT_NE(desk.document().model->deformers->deformers().back()->sketch().target, made->sketch().target);
  // Its place in the list.
  desk.click("Up");
  EXPECT_EQ(desk.document().model->deformers->deformers()[count - 2]->sketch().name, made->sketch().name);
  desk.click("Down");
  EXPECT_EQ(desk.document().model->deformers->deformers().back()->sketch().name, made->sketch().name);
}

TEST(App, NumbersAndRangesAreTypedWithThePenAlone) {
  Desk desk("numbers");
  desk.begin();
  const auto jaw = [&] { return *rig::find_parameter(desk.document().model->rig->parameters(), "jaw"); };
  const auto open = [&] {
    desk.app->panels().filter = "jaw";
    desk.frames();
    desk.click("=##type jaw");
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
  EXPECT_EQ(desk.app->panels().dialog, Dialog::number) << "what is no number is told";
  EXPECT_TRUE(desk.app->notices().back().is_error);
  desk.click("Rest##number");
  EXPECT_DOUBLE_EQ(desk.document().pose[jaw()], 0);
}

TEST(App, AKeyIsNamedDraggedAndKeepsItsNameWhenItIsKeyedAnew) {
  Desk desk("keys");
  desk.begin();
  desk.click("Key");
  desk.click("Name##key");
  desk.click("##key name");
  desk.click("key s");
  desk.click("key m");
  desk.click("Name it");
  ASSERT_EQ(desk.document().timeline->keys.front().name, "sm");
  desk.app->set_parameter(0, desk.document().model->rig->parameters()[0].maximum);
  desk.click("Key");
  EXPECT_EQ(desk.document().timeline->keys.front().name, "sm");
  const auto pose = desk.document().pose;
  const Area track = *desk.interface->find("track");
  const auto at = [&](double share) { return PxPoint{track.left + share * track.width(), track.middle().y}; };
  desk.app->mouse_moved(at(0.01));
  desk.app->mouse_button(MouseButton::left, true, at(0.01));
  desk.frames();
  for (const double share : {0.1, 0.3, 0.5}) {
    desk.app->mouse_moved(at(share));
    desk.frames(2);
  }
  EXPECT_EQ(desk.document().timeline->keys.front().time_s, 0) << "it moves when it is let go";
  desk.app->mouse_button(MouseButton::left, false, at(0.5));
  desk.frames();
  ASSERT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_NEAR(desk.document().timeline->keys.front().time_s, 2, 0.1);
  EXPECT_EQ(desk.document().timeline->keys.front().name, "sm");
  EXPECT_EQ(desk.document().pose, pose);
  // Nearer and farther.
  const double all = desk.app->panels().span_s;
  desk.click("+##track");
  EXPECT_GT(desk.app->panels().span_s, all);
  desk.click("-##track");
  EXPECT_EQ(desk.app->panels().span_s, 0);
}

TEST(App, ASessionPlayedInAWindowOfAnotherSizeEndsInTheSameState) {
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
    desk.stroke({line[10], line[10] + PxPoint{0, 15}});
    desk.click("Key");
    state = desk.app->workspace().state();
    std::filesystem::copy_file(desk.app->session_path(), desk.path("recorded.session"));
  }
  Desk desk("played", "builtin:demo", false);
  if (desk.app->panels().dialog == Dialog::recover) desk.click("Start anew");
  desk.app->resized({900, 1000}, 96);
  desk.frames();
  ASSERT_TRUE(desk.app->play_trace(desk.path("recorded.session")).ok());
  desk.app->player()->set_speed(16);
  for (int i = 0; i < 2000 && !desk.app->player()->finished(); ++i) desk.frames(1);
  ASSERT_TRUE(desk.app->player()->finished());
  EXPECT_EQ(desk.app->workspace().state(), state);
  EXPECT_EQ(desk.app->workspace().editor().view().viewport.width, 1280) << "as it was drawn";
  desk.frames(2);
  EXPECT_EQ(desk.app->workspace().editor().view().viewport.width, 900) << "one goes on in this window";
}

TEST(App, ACurveThatIsTouchedIsKeptOrDeletedWithThePenAlone) {
  Desk desk("curve-menu");
  desk.begin();
  pose_mouth(desk);
  desk.click("Select");
  const auto touch = [&] {
    const auto& curve = *desk.document().curves.front();
    const auto camera = geometry::Camera::make(desk.app->view().camera, desk.app->view().viewport);
    const PxPoint at = *camera->project(geometry::ModelPoint(desk.app->surface().at(curve.points[5])));
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

TEST(App, WorkThatASignalInterruptsIsOfferedAtTheNextStart) {
  document::DocumentState lost;
  {
    Desk desk("signal");
    desk.begin();
    pose_mouth(desk);
    lost = desk.app->workspace().state();
    desk.app->quit_at_once();
    EXPECT_TRUE(desk.app->wants_quit()) << "nobody is asked";
  }
  Desk desk("signal", "builtin:demo", false);
  ASSERT_EQ(desk.app->panels().dialog, Dialog::recover);
  desk.click("Bring it back");
  EXPECT_EQ(desk.app->workspace().state().parts[3], lost.parts[3]);
}

TEST(App, TouchingTheFaceWithTheToolSelectPicksTheControlThatMovesItMost) {
  Desk desk("pick");
  desk.begin();
  desk.click("Select");
  const auto brow = desk.named_curve("brow_L");
  desk.stroke({brow.front(), brow.front() + PxPoint{1, 0}});
  EXPECT_EQ(desk.app->panels().deformer.substr(0, 4), "brow");
  EXPECT_TRUE(desk.document().curves.empty());
}

TEST(App, OneFingerDrawsAndTwoTurnTheView) {
  Desk desk("fingers");
  desk.begin();
  const auto line = desk.named_curve(any_curve(desk));
  desk.app->finger(FingerKind::down, 7, line.front());
  for (const PxPoint& at : line) desk.app->finger(FingerKind::move, 7, at);
  desk.app->finger(FingerKind::up, 7, line.back());
  EXPECT_EQ(desk.document().curves.size(), 1U);
  const auto view = desk.app->view();
  desk.app->finger(FingerKind::down, 1, {400, 300});
  desk.app->finger(FingerKind::down, 2, {500, 300});
  desk.app->finger(FingerKind::move, 2, {560, 300});
  desk.app->finger(FingerKind::up, 1, {400, 300});
  desk.app->finger(FingerKind::up, 2, {560, 300});
  desk.frames();
  EXPECT_FALSE(desk.app->view() == view);
  EXPECT_EQ(desk.document().curves.size(), 1U);
  EXPECT_FALSE(desk.document().curves.front()->target.has_value());
}

TEST(App, OpeningAFileThatIsNoneSaysSoAndKeepsTheWork) {
  Desk desk("broken");
  desk.begin();
  std::ofstream(desk.path("broken.glb")) << "not a glb";
  pose_mouth(desk);
  const auto state = desk.app->workspace().state();
  desk.app->try_open(desk.path("broken.glb"));
  EXPECT_TRUE(desk.app->notices().back().is_error);
  EXPECT_EQ(desk.app->workspace().state(), state);
}

TEST(App, ASessionWithoutWorkLeavesNoFileBehind) {
  std::string session;
  {
    Desk desk("empty");
    session = desk.app->session_path();
    EXPECT_TRUE(std::filesystem::exists(session));
  }
  EXPECT_FALSE(std::filesystem::exists(session));
  EXPECT_FALSE(std::filesystem::exists(session + ".open"));
}

}  // namespace
}  // namespace penpose::app
