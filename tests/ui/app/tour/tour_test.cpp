#include "ui/app/tour/tour.h"

#include <gtest/gtest.h>

#include "core/document/document.h"
#include "replay/session/session_player.h"
#include "tests/support/app_desk.h"
#include "ui/app/dialogs/found_command.h"
#include "ui/files/load_model.h"

namespace penpose::app {
namespace {

constexpr const char* k_model =
    "# penpose session edition=11 program=hand\n# penpose model d9eb8e7c2a4ecb586c0633356794d8da path=builtin%3Ademo\n";

TEST(Tour, EveryBundledTourIsASessionThatReplaysToItsStates) {
  for (const std::string_view name : k_tours) {
    replay::PlayerOptions options;
    options.open = [](const std::string& path) { return files::load_document(path); };
    const auto played = replay::play_session(replay::read_from(base::as_bytes(tour_session(name))), options);
    ASSERT_TRUE(played.ok()) << name;
    EXPECT_GE(played->checked, 5U) << name;
    EXPECT_EQ(played->differing, 0U) << name;
    EXPECT_EQ(played->refused, 0U) << name;
  }
}

TEST(Tour, TheFirstIsOfSixStrokesAndEachStepSaysSomething) {
  for (const std::string_view name : k_tours) {
    const auto tour = read_tour(name, tour_session(name));
    ASSERT_TRUE(tour.ok()) << tour.error().line();
    EXPECT_FALSE(tour->title.empty());
    EXPECT_FALSE(tour->ends.empty());
    for (const TourStep& step : tour->steps) {
      EXPECT_GT(step.says.size(), 10U);
      EXPECT_LT(step.says.size(), 70U) << "a short sentence: " << step.says;
    }
  }
  EXPECT_EQ(read_tour("pose", tour_session("pose"))->steps.size(), 6U);
}

TEST(Tour, WhatIsNoTourIsRefusedWithItsLine) {
  for (const std::string& text :
       {std::string("# tour says Nothing\n"), std::string(k_model), std::string(k_model) + "# penpose do set_key\n",
        std::string(k_model) + "# tour sings\n", std::string(k_model) + "# tour press nothing Press\n",
        std::string(k_model) + "# tour says Draw\n# penpose do draw_nothing\n"}) {
    EXPECT_FALSE(read_tour("x", text).ok()) << text;
  }
  const auto unsaid = read_tour("x", std::string(k_model) + "# penpose do set_key\n");
  ASSERT_FALSE(unsaid.ok());
  EXPECT_NE(unsaid.error().line().find("line 3"), std::string::npos) << unsaid.error().line();
}

/// The line that a tour shows, as the hand sees it; moved by some px.
std::vector<PxPoint> shown_line(Desk& desk, PxPoint by = {}) {
  const document::View& view = desk.app->of<Canvas>().view();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  std::vector<PxPoint> line;
  for (const auto& point : desk.app->of<TourGuide>().ghost()) line.push_back(*camera->project(point) + by);
  return line;
}

void begin_tour(Desk& desk, const std::string& name) {
  desk.begin();
  desk.app->of<Files>().try_open("tour:" + name);
  desk.frames();
  ASSERT_TRUE(desk.app->of<TourGuide>().active());
}

TEST(Tour, TheFirstStartOffersThemAndTheSearchFindsThem) {
  Desk desk("tour-offer");
  EXPECT_NE(desk.interface->find("Tour: pose a face"), nullptr);
  desk.click("Tour: pose a face");
  ASSERT_TRUE(desk.app->of<TourGuide>().active());
  EXPECT_EQ(desk.app->of<TourGuide>().tour().name, "pose");
  EXPECT_TRUE(desk.app->of<Preferences>().settings().steps_seen) << "it is not offered at every start";
  const auto found = find_commands({desk.document(), {}, 24, {}}, "tour");
  ASSERT_GE(found.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(found[i].text.starts_with("Tour: ")) << found[i].text;
}

TEST(Tour, SixStrokesOfTheHandGoThroughTheFirst) {
  Desk desk("tour-pose");
  begin_tour(desk, "pose");
  for (std::size_t step = 0; step < 6; ++step) {
    ASSERT_EQ(desk.app->of<TourGuide>().step(), step) << desk.app->of<TourGuide>().again();
    // A hand is not exact.
    desk.stroke(shown_line(desk, {2, -2}));
  }
  EXPECT_TRUE(desk.app->of<TourGuide>().done()) << desk.app->of<TourGuide>().again();
  EXPECT_EQ(desk.document().curves.size(), 3U);
  EXPECT_NE(desk.interface->find("Next tour##tour"), nullptr);
}

TEST(Tour, AStrokeElsewhereIsTakenBackAndSaidWhy) {
  Desk desk("tour-wrong");
  begin_tour(desk, "pose");
  desk.stroke(shown_line(desk, {0, -90}));
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 0U);
  EXPECT_NE(desk.app->of<TourGuide>().again().find("Too far up"), std::string::npos)
      << desk.app->of<TourGuide>().again();
  EXPECT_TRUE(desk.document().curves.empty());
  desk.stroke(shown_line(desk));
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 1U);
  EXPECT_EQ(desk.app->of<TourGuide>().again(), "");
  // Where the feature is already is no target for it.
  desk.stroke(desk.named_curve("lip_upper_inner"));
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 1U);
  EXPECT_FALSE(desk.document().curves.front()->target.has_value());
  EXPECT_NE(desk.app->of<TourGuide>().again(), "");
}

TEST(Tour, WhoTakesBackAStrokeIsShownItAgain) {
  Desk desk("tour-undo");
  begin_tour(desk, "pose");
  desk.stroke(shown_line(desk));
  desk.stroke(shown_line(desk));
  ASSERT_EQ(desk.app->of<TourGuide>().step(), 2U);
  desk.app->of<Playback>().undo();
  desk.frames();
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 1U);
  desk.stroke(shown_line(desk));
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 2U);
}

TEST(Tour, AnotherToolIsAskedToBePutAway) {
  Desk desk("tour-tool");
  begin_tour(desk, "pose");
  desk.click("Erase");
  EXPECT_EQ(desk.app->of<TourGuide>().pointed(), "Pose");
  EXPECT_TRUE(desk.app->of<TourGuide>().says().starts_with("Press Pose first"));
  desk.click("Pose");
  EXPECT_EQ(desk.app->of<TourGuide>().pointed(), "");
}

TEST(Tour, TheLineIsShownOnTheFaceFromWhereverOneLooks) {
  Desk desk("tour-view");
  begin_tour(desk, "pose");
  const auto before = shown_line(desk);
  desk.press(k_key_right);
  const auto after = shown_line(desk);
  EXPECT_GT(geometry::distance(before.front(), after.front()), 5);
  // It goes on lying on the lips.
  const auto lips = desk.named_curve("lip_upper_inner");
  EXPECT_LT(geometry::distance(after[after.size() / 2], lips[lips.size() / 2]), 12);
  desk.stroke(after);
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 1U) << desk.app->of<TourGuide>().again();
}

TEST(Tour, ThreeLinesMakeTheControlOfTheSecond) {
  Desk desk("tour-rig");
  begin_tour(desk, "rig");
  EXPECT_EQ(desk.app->of<TourGuide>().pointed(), "Rig");
  desk.click("Rig");
  for (int i = 0; i < 3; ++i) desk.stroke(shown_line(desk, {1, 2}));
  ASSERT_EQ(desk.app->of<TourGuide>().step(), 4U) << desk.app->of<TourGuide>().again();
  const std::string slider = desk.app->of<TourGuide>().pointed();
  const Area* found = desk.interface->find(slider);
  ASSERT_NE(found, nullptr) << slider;
  const Area at = *found;
  const PxPoint middle = at.middle();
  // Its target is where it stands at first, and its rest is not the middle.
  EXPECT_FALSE(desk.app->of<TourGuide>().done());
  desk.app->of<Controls>().set_parameter(0, 0.1);
  desk.frames();
  EXPECT_FALSE(desk.app->of<TourGuide>().done());
  EXPECT_EQ(desk.app->of<TourGuide>().again(), "Further to the right");
  const PxPoint end{at.left + 10, middle.y};
  desk.app->of<Pointer>().moved(end);
  desk.app->of<Pointer>().button(MouseButton::left, true, end);
  desk.frames();
  desk.app->of<Pointer>().moved(middle);
  desk.frames();
  desk.app->of<Pointer>().button(MouseButton::left, false, middle);
  desk.frames();
  EXPECT_TRUE(desk.app->of<TourGuide>().done()) << desk.app->of<TourGuide>().again();
}

TEST(Tour, TwoKeysAndPlayEndTheThird) {
  Desk desk("tour-animate");
  begin_tour(desk, "animate");
  desk.click("Key");
  ASSERT_EQ(desk.app->of<TourGuide>().step(), 1U);
  desk.app->of<Playback>().go_to(0.5);
  desk.frames();
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 1U);
  EXPECT_NE(desk.app->of<TourGuide>().again().find("frame"), std::string::npos);
  const Area* mark = desk.interface->find("tour time");
  ASSERT_NE(mark, nullptr);
  const PxPoint at = mark->middle();
  desk.stroke({{at.x - 60, at.y}, at});
  ASSERT_EQ(desk.app->of<TourGuide>().step(), 2U) << desk.app->of<TourGuide>().again();
  desk.stroke(shown_line(desk));
  desk.stroke(shown_line(desk));
  desk.click("Key");
  ASSERT_EQ(desk.app->of<TourGuide>().step(), 5U) << desk.app->of<TourGuide>().again();
  desk.click("Play");
  EXPECT_TRUE(desk.app->of<TourGuide>().done());
  EXPECT_EQ(desk.document().timeline->keys.size(), 2U);
}

TEST(Tour, EveryStepCanBeSkippedAndTheTourLeft) {
  for (const std::string_view name : k_tours) {
    Desk desk("tour-skip-" + std::string(name));
    begin_tour(desk, std::string(name));
    const std::size_t steps = desk.app->of<TourGuide>().tour().steps.size();
    for (std::size_t i = 0; i < steps; ++i) {
      ASSERT_EQ(desk.app->of<TourGuide>().step(), i) << name << ": " << desk.app->of<TourGuide>().again();
      desk.click("Skip##tour");
    }
    EXPECT_TRUE(desk.app->of<TourGuide>().done()) << name;
    desk.click("Close##tour");
    EXPECT_FALSE(desk.app->of<TourGuide>().active());
  }
  Desk desk("tour-leave");
  begin_tour(desk, "pose");
  desk.stroke(shown_line(desk));
  desk.click("Leave##tour");
  EXPECT_FALSE(desk.app->of<TourGuide>().active());
  EXPECT_EQ(desk.document().curves.size(), 1U) << "what was drawn stays";
}

TEST(Tour, AnotherModelEndsIt) {
  Desk desk("tour-open");
  begin_tour(desk, "pose");
  ASSERT_TRUE(desk.app->of<Files>().open("builtin:head").ok());
  desk.frames();
  EXPECT_FALSE(desk.app->of<TourGuide>().active());
}

TEST(Tour, TheCardCutsNothingInAWindowOfAnySize) {
  Desk desk("tour-size");
  begin_tour(desk, "pose");
  for (const auto& [width, height] : {std::pair{800, 600}, std::pair{1280, 800}, std::pair{3840, 2160}}) {
    desk.app->of<Pointer>().resized({width, height}, 96);
    desk.frames();
    const Area free = desk.app->of<Canvas>().free_area();
    for (const PxPoint& p : shown_line(desk)) EXPECT_TRUE(free.holds(p)) << width;
    for (const char* label : {"Skip##tour", "Leave##tour"}) {
      const Area* at = desk.interface->find(label);
      ASSERT_NE(at, nullptr) << label << " at " << width;
      EXPECT_GE(at->top, free.bottom) << "the card lies below the canvas";
    }
  }
}

TEST(Tour, AStrokeFiftyPxOffDoesNotCountAndItIsSaidWhyWhateverTheToolMadeOfIt) {
  for (const std::string_view name : {"pose", "rig"}) {
    Desk desk("tour-off-" + std::string(name));
    begin_tour(desk, std::string(name));
    const TourGuide& guide = desk.app->of<TourGuide>();
    while (!guide.done()) {
      const std::size_t step = guide.step();
      if (!guide.ghost().empty() && guide.pointed().empty()) {
        for (const PxPoint off : {PxPoint{0, -50}, PxPoint{0, 50}, PxPoint{50, 0}}) {
          const std::string where = std::string(name) + " step " + std::to_string(step) + " " + std::to_string(off.x) +
                                    "," + std::to_string(off.y);
          const std::size_t done = desk.app->of<EditingSession>().editor().history().undo_count();
          const bool may_count = guide.ghost_closed() || off.y == 0;
          desk.stroke(shown_line(desk, off));
          // Around a region, or along a line beside its ends, it may be near enough.
          if (may_count && guide.step() == step + 1) {
            desk.app->of<Playback>().undo();
            desk.frames();
          }
          ASSERT_EQ(guide.step(), step) << where;
          if (may_count && guide.again().empty()) continue;
          EXPECT_NE(guide.again(), "") << where;
          EXPECT_EQ(desk.app->of<EditingSession>().editor().history().undo_count(), done) << where;
        }
      }
      desk.click("Skip##tour");
      ASSERT_GT(guide.step(), step);
    }
  }
}

TEST(Tour, ALineOfAnotherToolIsTakenBackAndTheToolIsNamed) {
  Desk desk("tour-tool");
  begin_tour(desk, "pose");
  desk.click("Draw");
  desk.stroke(shown_line(desk));
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 0U);
  EXPECT_NE(desk.app->of<TourGuide>().again().find("press Pose"), std::string::npos)
      << desk.app->of<TourGuide>().again();
  EXPECT_FALSE(desk.document().face);
}

TEST(Tour, AStrokeThatBeginsBelowThePictureIsSaidToDrawNothing) {
  Desk desk("tour-below");
  begin_tour(desk, "pose");
  // By hand a line has as many frames as points.
  const PxPoint at{desk.app->of<Canvas>().free_area().left + 40, desk.app->of<Canvas>().free_area().bottom + 6};
  desk.app->of<Pointer>().moved(at);
  desk.app->of<Pointer>().button(MouseButton::left, true, at);
  desk.frames();
  EXPECT_EQ(desk.app->of<TourGuide>().again(), "") << "a touch is no line";
  desk.app->of<Pointer>().moved(at + PxPoint{120, 4});
  desk.frames();
  desk.app->of<Pointer>().button(MouseButton::left, false, at + PxPoint{120, 4});
  desk.frames();
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 0U);
  EXPECT_NE(desk.app->of<TourGuide>().again().find("beside the picture"), std::string::npos)
      << desk.app->of<TourGuide>().again();
  // Neither is a press of a button that slips.
  desk.stroke(shown_line(desk));
  ASSERT_EQ(desk.app->of<TourGuide>().step(), 1U);
  const PxPoint skip = desk.interface->find("Skip##tour")->middle();
  desk.app->of<Pointer>().moved(skip);
  desk.app->of<Pointer>().button(MouseButton::left, true, skip);
  desk.frames();
  desk.app->of<Pointer>().moved(skip - PxPoint{300, 0});
  desk.frames();
  desk.app->of<Pointer>().button(MouseButton::left, false, skip - PxPoint{300, 0});
  desk.frames();
  EXPECT_EQ(desk.app->of<TourGuide>().step(), 1U);
  EXPECT_EQ(desk.app->of<TourGuide>().again(), "");
}

}  // namespace
}  // namespace penpose::app
