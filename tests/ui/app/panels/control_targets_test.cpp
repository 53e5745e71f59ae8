#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/articulation/edit.h"
#include "tests/support/app_desk.h"

// What a control's target can be after it was drawn first: several at several values, pulled, on another sheet,
// doubted.

namespace penpose::app {
namespace {

using articulation::Deformer;

/// A desk with a control below the mouth, its target `target` px down.
class Chin {
 public:
  explicit Chin(const std::string& name) : desk(name) {
    desk.begin();
    desk.click("Rig");
    const auto mouth = desk.named_curve(any_curve(desk));
    middle = mouth[mouth.size() / 2] + PxPoint{0, 55};
  }
  void lassos() {
    desk.stroke(around(middle, 70, 42));
    desk.stroke(around(middle, 30, 14));
  }
  void sketch(double down = 10) {
    lassos();
    desk.stroke(target_line(down));
  }
  [[nodiscard]] std::vector<PxPoint> target_line(double down) const {
    return {middle + PxPoint{-26, down}, middle + PxPoint{0, down + 6}, middle + PxPoint{26, down}};
  }
  [[nodiscard]] const Deformer& made() const { return *desk.document().model->deformers->deformers().back(); }
  [[nodiscard]] std::size_t parameter() const {
    return *rig::find_parameter(desk.document().model->rig->parameters(), made().sketch().name);
  }
  [[nodiscard]] bool says(const std::string& part) const {
    const auto& notices = desk.app->of<Notices>().all();
    return std::any_of(notices.begin(), notices.end(),
                       [&](const Notice& one) { return one.text.find(part) != std::string::npos; });
  }
  [[nodiscard]] std::vector<PxPoint> seen(std::span<const geometry::ModelPoint> line) const {
    const auto camera =
        *geometry::Camera::make(desk.app->of<Canvas>().view().camera, desk.app->of<Canvas>().view().viewport);
    std::vector<PxPoint> px;
    for (const auto& point : line) px.push_back(*camera.project(point));
    return px;
  }

  Desk desk;
  PxPoint middle;
};

TEST(ControlTargets, AFeatureThatWasFoundByAGuessIsDoubtedBeforeTheTargetIsDrawn) {
  Chin chin("guess");
  chin.desk.stroke(around(chin.middle, 70, 42));
  EXPECT_FALSE(chin.says("The green line"));
  chin.desk.stroke(around(chin.middle, 20, 18));
  EXPECT_TRUE(chin.says("The green line is the feature that was found, but"));
}

TEST(ControlTargets, AnotherTargetIsDrawnAtTheValueThatTheSliderShowsDrawnAgainAndForgotten) {
  Chin chin("between");
  chin.sketch();
  const auto whole = chin.made().curve_at(1);
  chin.desk.app->of<Controls>().set_parameter(chin.parameter(), 0.5);
  chin.desk.frames();
  chin.desk.click("Another target at 0.50##between");
  std::vector<PxPoint> aside = chin.target_line(4);
  for (PxPoint& p : aside) p.x += 14;
  chin.desk.stroke(aside);
  ASSERT_EQ(chin.made().sketch().betweens.size(), 1U);
  EXPECT_EQ(chin.made().sketch().betweens[0].value, 0.5);
  const auto lies = [&](double value, const std::vector<geometry::ModelPoint>& line) {
    double off = 0;
    const auto reached = chin.made().curve_at(value);
    for (std::size_t i = 0; i < reached.size(); ++i) off = std::max(off, geometry::distance(reached[i], line[i]));
    return off;
  };
  EXPECT_LE(lies(0.5, {chin.made().betweens()[0].begin(), chin.made().betweens()[0].end()}), 1e-9);
  EXPECT_LE(lies(1, whole), 1e-9) << "its own target is where it was";
  const auto first = chin.made().sketch().betweens[0].target;
  chin.desk.click("Target at 0.50##again0.50");
  chin.desk.stroke(chin.target_line(-6));
  ASSERT_EQ(chin.made().sketch().betweens.size(), 1U);
  EXPECT_NE(chin.made().sketch().betweens[0].target, first);
  chin.desk.click("Remove##between0.50");
  EXPECT_TRUE(chin.made().sketch().betweens.empty());
  EXPECT_LE(lies(1, whole), 1e-9);
}

TEST(ControlTargets, ATargetIsPulledWhereItIsHeldAndTheRestOfItLess) {
  Chin chin("pull");
  chin.sketch();
  const std::vector<geometry::ModelPoint> before(chin.made().target().begin(), chin.made().target().end());
  const auto line = chin.seen(before);
  const std::size_t n = line.size(), held = n / 5;
  chin.desk.app->of<Actions>().run(Action::tool_select);
  chin.desk.frames();
  const std::vector<PxPoint> way{line[held], line[held] + PxPoint{0, 8}};
  chin.desk.stroke(way);
  const auto after = chin.seen(chin.made().target());
  EXPECT_NEAR(after[held].y - line[held].y, 8, 1.5);
  EXPECT_NEAR(geometry::distance(after[n - 1], line[n - 1]), 0, 0.5) << "what is far from the hand stays";
  EXPECT_GT(after[n / 3].y - line[n / 3].y, 0.5);
  EXPECT_LT(after[n / 3].y - line[n / 3].y, 7.5);
}

TEST(ControlTargets, TheFaceFollowsWhileATargetIsPulledAndIsTheDocumentsAgainAfterwards) {
  Chin chin("pull-live");
  chin.sketch();
  chin.desk.app->of<Controls>().set_parameter(chin.parameter(), 0.0);
  chin.desk.app->of<Actions>().run(Action::tool_select);
  chin.desk.frames();
  const auto line = chin.seen(chin.made().target());
  const std::size_t held = line.size() / 5;
  const auto shown = [&] {
    document::Model model = *chin.desk.app->of<EditingSession>().shown().model();
    model.pose = chin.desk.app->of<EditingSession>().shown().pose();
    return document::posed_positions(model);
  };
  const auto moved = [](const std::vector<geometry::ModelPoint>& a, const std::vector<geometry::ModelPoint>& b) {
    double most = 0;
    for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, geometry::distance(a[v], b[v]));
    return most;
  };
  const auto rest = shown();
  const std::uint64_t steps = chin.desk.app->of<EditingSession>().steps().can_undo();
  chin.desk.app->of<Pointer>().moved(line[held]);
  chin.desk.app->of<Pointer>().button(MouseButton::left, true, line[held]);
  chin.desk.frames();
  EXPECT_EQ(moved(shown(), rest), 0) << "only taken in hand yet";
  auto before = rest;
  for (int k = 1; k <= 3; ++k) {
    chin.desk.now_us += 3000;
    chin.desk.app->of<Pointer>().moved(line[held] + PxPoint{0, 8.0 * k});
    chin.desk.frames();
    const auto now = shown();
    EXPECT_GT(moved(now, before), 0.0005) << k << ": the face follows the pen";
    before = now;
  }
  EXPECT_EQ(chin.desk.app->of<EditingSession>().steps().can_undo(), steps) << "nothing is done before the pen lifts";
  chin.desk.app->of<Pointer>().button(MouseButton::left, false, line[held] + PxPoint{0, 24});
  chin.desk.frames();
  EXPECT_EQ(moved(shown(), rest), 0) << "the slider is where it was";
  // What was shown is what was made.
  chin.desk.app->of<Controls>().set_parameter(chin.parameter(), 1.0);
  chin.desk.frames();
  EXPECT_LT(moved(shown(), before), 1e-9);
}

TEST(ControlTargets, ByItsMiddleOrWithAModifierAllOfATargetIsMoved) {
  for (const bool modifier : {false, true}) {
    Chin chin("pull-whole");
    chin.sketch();
    const auto line = chin.seen(chin.made().target());
    const std::size_t n = line.size();
    const PxPoint from = modifier ? line[n / 5] : line[n / 2];
    chin.desk.app->of<Actions>().run(Action::tool_select);
    chin.desk.frames();
    chin.desk.app->of<Pointer>().moved(from);
    chin.desk.app->of<Pointer>().button(MouseButton::left, true, from, modifier);
    for (int k = 1; k <= 8; ++k) {
      chin.desk.now_us += 3000;
      chin.desk.app->of<Pointer>().moved(from + PxPoint{0, 1.0 * k});
    }
    chin.desk.app->of<Pointer>().button(MouseButton::left, false, from + PxPoint{0, 8});
    chin.desk.frames();
    const auto after = chin.seen(chin.made().target());
    for (const std::size_t i : {std::size_t{0}, n / 2, n - 1}) {
      EXPECT_NEAR(after[i].y - line[i].y, 8, 1) << (modifier ? "modifier " : "middle ") << i;
    }
  }
}

TEST(ControlTargets, OfTwoLipsTheOtherSheetIsATapAway) {
  Chin chin("sheet");
  const auto mouth = chin.desk.named_curve(any_curve(chin.desk));
  const PxPoint middle = mouth[mouth.size() / 2];
  chin.desk.click("Draw the feature myself");
  chin.desk.stroke(around(middle, 80, 60));
  chin.desk.stroke(around(middle, 40, 16));
  chin.desk.stroke({mouth.begin() + static_cast<std::ptrdiff_t>(mouth.size() / 4),
                    mouth.begin() + static_cast<std::ptrdiff_t>(3 * mouth.size() / 4)});
  std::vector<PxPoint> target(mouth.begin() + static_cast<std::ptrdiff_t>(mouth.size() / 4),
                              mouth.begin() + static_cast<std::ptrdiff_t>(3 * mouth.size() / 4));
  for (PxPoint& p : target) p.y += 8;
  chin.desk.stroke(target);
  ASSERT_FALSE(chin.desk.document().pending);
  const double before = chin.seen(chin.made().reference())[10].y;
  chin.desk.click("Other sheet");
  EXPECT_TRUE(chin.made().sketch().other_sheet);
  EXPECT_NE(chin.seen(chin.made().reference())[10].y, before);
  chin.desk.click("Other sheet");
  EXPECT_FALSE(chin.made().sketch().other_sheet);
  EXPECT_EQ(chin.seen(chin.made().reference())[10].y, before);
}

TEST(ControlTargets, ATargetFarLongerThanItsFeatureIsToldAtOnceAndByHowMuch) {
  Chin chin("doubts");
  chin.lassos();
  chin.desk.stroke({chin.middle + PxPoint{-130, 12}, chin.middle + PxPoint{0, 26}, chin.middle + PxPoint{130, 12}});
  EXPECT_TRUE(chin.says("times as long as the feature, and what lies along it is stretched by as much"));
}

TEST(ControlTargets, ADoubtfulTargetIsToldAlsoWhenItIsDrawnAgain) {
  Chin other("doubts-again");
  other.sketch();
  EXPECT_FALSE(other.says("times as long as the feature"));
  other.desk.click("Target");
  other.desk.stroke({other.middle + PxPoint{-130, 12}, other.middle + PxPoint{0, 26}, other.middle + PxPoint{130, 12}});
  EXPECT_TRUE(other.says("times as long as the feature"));
}

TEST(ControlTargets, ATargetThatRunsAgainstADrawnFeatureIsToldToHaveBeenTurnedRound) {
  Chin chin("turned");
  chin.desk.click("Draw the feature myself");
  chin.lassos();
  chin.desk.stroke(chin.target_line(0));
  auto back = chin.target_line(12);
  std::reverse(back.begin(), back.end());
  chin.desk.stroke(back);
  ASSERT_FALSE(chin.desk.document().pending);
  EXPECT_TRUE(chin.made().turned_round());
  EXPECT_TRUE(chin.says("turned round"));
}

TEST(ControlTargets, TheFirstLineTakesWhatIsSeenOrAllThrough) {
  Chin chin("front");
  chin.desk.stroke(around(chin.middle, 70, 42));
  ASSERT_TRUE(chin.desk.document().pending);
  chin.desk.click("Front only");
  EXPECT_EQ(chin.desk.document().pending->sketch.reach, articulation::Reach::front);
  chin.desk.stroke(around(chin.middle, 30, 14));
  chin.desk.stroke(chin.target_line(10));
  ASSERT_FALSE(chin.desk.document().pending);
  const auto front = chin.made().vertices().size();
  chin.desk.click("Through");
  EXPECT_EQ(chin.made().sketch().reach, articulation::Reach::through);
  EXPECT_GE(chin.made().vertices().size(), front);
}

TEST(ControlTargets, TheOtherPiecesInsideTheFirstLineAreATapAway) {
  Chin chin("piece");
  const auto lid = chin.desk.named_curve("eyelid_upper_L");
  const PxPoint eye = lid[lid.size() / 2] + PxPoint{0, 8};
  chin.desk.stroke(around(eye, 60, 40));
  const auto pieces = chin.desk.app->of<EditingSession>().shown().sketch().pieces();
  ASSERT_GT(pieces, 1U) << "the eye lies inside the line as well as the skin";
  const std::string many = std::to_string(pieces);
  chin.desk.click("Piece 1 of " + many + ": take the next##piece");
  EXPECT_EQ(chin.desk.document().pending->sketch.piece, 1U);
  chin.desk.click("Piece 2 of " + many + ": take the next##piece");
  EXPECT_EQ(chin.desk.document().pending->sketch.piece, 2U % pieces);
}

TEST(ControlTargets, LinesThatTakeNothingOrCrossThemselvesSayItAndChangeNothing) {
  Chin chin("nothing");
  chin.desk.stroke(around({chin.middle.x - 330, chin.middle.y - 300}, 20, 20));
  const auto begun = chin.desk.app->of<EditingSession>().state();
  EXPECT_TRUE(!chin.desk.document().pending || chin.desk.document().pending->sketch.general.empty());
  EXPECT_TRUE(chin.says("draw around everything on the face that may move"));
  // An eight.
  std::vector<PxPoint> eight;
  for (int i = 0; i <= 32; ++i) {
    const double t = 2 * 3.14159265 * i / 32;
    eight.push_back(chin.middle + PxPoint{60 * std::sin(t), 30 * std::sin(2 * t)});
  }
  chin.desk.stroke(eight);
  EXPECT_TRUE(chin.says("crosses itself"));
  EXPECT_EQ(chin.desk.app->of<EditingSession>().state(), begun);
  chin.desk.stroke(around(chin.middle, 70, 42));
  const auto lassoed = chin.desk.app->of<EditingSession>().state();
  chin.desk.stroke(around(chin.middle + PxPoint{0, -200}, 12, 8));
  EXPECT_EQ(chin.desk.app->of<EditingSession>().state(), lassoed) << "a core outside of the region";
  EXPECT_TRUE(chin.says("middle of the first")) << "and where it lies is said";
}

}  // namespace
}  // namespace penpose::app
