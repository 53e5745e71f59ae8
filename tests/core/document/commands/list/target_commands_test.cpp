#include <cmath>
#include <gtest/gtest.h>

#include "core/document/commands/command_text.h"
#include "tests/support/document_hand.h"

// Other targets of deformers, corrections, targets that are bent, and what the first lasso takes.

namespace penpose::document {
namespace {

using articulation::CurveRole;
using articulation::Reach;
using tests::DocumentHand;

/// Sketches how the middle comes down.
void bring_down(DocumentHand& hand) {
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.5)});
  hand.does(SketchCurve{CurveRole::reference, hand.view, hand.line(-0.1, 0.25, 0.4, 0.25)});
  hand.does(SketchCurve{CurveRole::target, hand.view, hand.line(-0.1, 0.05, 0.4, 0.05)});
}

/// A control that brings the middle of the sheet `by` up, to the right of `middle` or about it.
void sketch(DocumentHand& hand, const std::string& name, double up) {
  hand.does(BeginDeformer{name, articulation::Mode::translate, {}, 0, 1});
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)});
  hand.does(SketchCurve{CurveRole::reference, hand.view, hand.line(-0.3, 0, 0.3, 0)});
  hand.does(SketchCurve{CurveRole::target, hand.view, hand.line(-0.3, up, 0.3, up)});
}

std::vector<geometry::ModelPoint> posed(const DocumentHand& hand, std::vector<NamedValue> values) {
  Model model = *hand.document().model;
  model.pose = rig::rest_pose(*model.rig);
  for (const NamedValue& one : values) model.pose[*rig::find_parameter(model.rig->parameters(), one.name)] = one.value;
  return posed_positions(model);
}

double middle(const std::vector<geometry::ModelPoint>& positions) { return positions[7 * 15 + 7].y; }

const articulation::Deformer& only(const DocumentHand& hand) {
  return *hand.document().model->deformers->deformers()[0];
}

TEST(DrawBetween, GivesAControlAnotherTarget) {
  DocumentHand hand;
  sketch(hand, "up", 0.3);
  const double rest = middle(posed(hand, {}));
  const double whole = middle(posed(hand, {{"up", 1}}));
  const auto before = hand.state();
  hand.does(DrawBetween{"up", 0.5, hand.view, hand.line(-0.3, -0.2, 0.3, -0.2)});
  EXPECT_NE(hand.state(), before);
  EXPECT_NEAR(middle(posed(hand, {{"up", 0.5}})), rest - 0.2, 0.03) << "half-way it is down";
  EXPECT_NEAR(middle(posed(hand, {{"up", 1}})), whole, 1e-9) << "at 1 it is where it was";
  EXPECT_NEAR(middle(posed(hand, {{"up", 0.25}})), 0.5 * (rest + middle(posed(hand, {{"up", 0.5}}))), 0.01);
  // Drawn again, it gives way to the new one; deleted, all is as it was before.
  hand.does(DrawBetween{"up", 0.5, hand.view, hand.line(-0.3, 0.2, 0.3, 0.2)});
  EXPECT_EQ(only(hand).betweens().size(), 1U);
  EXPECT_NEAR(middle(posed(hand, {{"up", 0.5}})), rest + 0.2, 0.03);
  hand.does(DrawBetween{"up", 0.25, hand.view, hand.line(-0.3, 0.1, 0.3, 0.1)});
  EXPECT_EQ(only(hand).sketch().betweens[0].value, 0.25) << "in their order";
  hand.does(DeleteBetween{"up", 0.25});
  hand.does(DeleteBetween{"up", 0.5});
  EXPECT_EQ(hand.state(), before);
}

TEST(DrawBetween, WhatCannotBeChangesNothing) {
  DocumentHand hand;
  sketch(hand, "up", 0.3);
  const auto line = hand.line(-0.3, -0.2, 0.3, -0.2);
  EXPECT_EQ(hand.refuses(DrawBetween{"down", 0.5, hand.view, line}).place, "deformer");
  EXPECT_EQ(hand.refuses(DrawBetween{"up", 0, hand.view, line}).place, "betweens/0/value");
  EXPECT_EQ(hand.refuses(DrawBetween{"up", 1, hand.view, line}).place, "betweens/0/value");
  EXPECT_EQ(hand.refuses(DrawBetween{"up", 1.5, hand.view, line}).place, "betweens/0/value");
  EXPECT_EQ(hand.refuses(DrawBetween{"up", 0.5, hand.view, {}}).place, "betweens/0/target");
  EXPECT_EQ(hand.refuses(DeleteBetween{"up", 0.5}).place, "value");
  View nowhere = hand.view;
  nowhere.camera.look_at = nowhere.camera.eye;
  hand.refuses(DrawBetween{"up", 0.5, nowhere, line});
}

TEST(PullBetween, BendsATargetWhereItIsHeld) {
  DocumentHand hand;
  sketch(hand, "up", 0.3);
  const auto before = std::vector(only(hand).target().begin(), only(hand).target().end());
  const PxPoint held = hand.seen(-0.3, 0.3);
  hand.does(PullBetween{"up", 1, hand.view, held, {0, -40}, 0.35});
  const auto after = only(hand).target();
  EXPECT_GT(after.front().y, before.front().y + 0.08) << "the end that was held";
  EXPECT_NEAR(after.back().y, before.back().y, 1e-6) << "the other end is out of reach";
  // The whole line goes by as much everywhere, and other targets are pulled likewise.
  hand.does(PullBetween{"up", 1, hand.view, held, {0, 20}, 0});
  EXPECT_LT(only(hand).target().back().y, before.back().y - 0.04);
  hand.does(DrawBetween{"up", 0.5, hand.view, hand.line(-0.3, 0.1, 0.3, 0.1)});
  const double between = only(hand).betweens()[0].back().y;
  hand.does(PullBetween{"up", 0.5, hand.view, hand.seen(0.3, 0.1), {0, -30}, 0.35});
  EXPECT_GT(only(hand).betweens()[0].back().y, between + 0.05);
  EXPECT_EQ(hand.refuses(PullBetween{"up", 0.7, hand.view, held, {0, 1}, 0.3}).place, "value");
  EXPECT_EQ(hand.refuses(PullBetween{"up", 1, hand.view, held, {0, 1}, -1}).place, "reach");
  EXPECT_EQ(hand.refuses(PullBetween{"up", 1, hand.view, held, {3e6, 1}, 0.3}).place, "by");
}

TEST(PullBetween, AnotherViewMovesItParallelToThatPicture) {
  DocumentHand hand;
  sketch(hand, "up", 0.3);
  const double before = only(hand).target().front().y;
  View other = hand.view;
  other.camera.eye = {2, 0, 5.6};
  const auto camera = geometry::Camera::make(other.camera, other.viewport).value();
  hand.does(PullBetween{"up", 1, other, *camera.project(only(hand).target().front()), {0, -40}, 0.35});
  EXPECT_GT(only(hand).target().front().y, before + 0.08);
  EXPECT_TRUE(only(hand).sketch().target_camera.has_value());
}

TEST(PullTarget, MovesThePlaceThatIsHeldAndLeavesTheRestToTheBit) {
  DocumentHand hand;
  hand.does(DrawReference{hand.view, hand.line(-0.4, 0, 0.4, 0)});
  hand.does(DrawTarget{CurveId{1}, hand.view, hand.line(-0.4, 0.1, 0.4, 0.1), {}});
  const auto before = *find_curve(hand.document(), CurveId{1})->target;
  hand.does(PullTarget{CurveId{1}, hand.view, hand.seen(-0.4, 0.1), {0, -30}, 0.3});
  const auto after = *find_curve(hand.document(), CurveId{1})->target;
  EXPECT_GT(after.points.front().y, before.points.front().y + 0.05);
  for (std::size_t i = after.points.size() / 2; i < after.points.size(); ++i) {
    EXPECT_EQ(after.points[i], before.points[i]) << i;
  }
  hand.does(PullTarget{CurveId{1}, hand.view, hand.seen(0, 0.1), {0, 25}, 0});
  const auto whole = *find_curve(hand.document(), CurveId{1})->target;
  for (std::size_t i = 0; i < whole.points.size(); ++i) EXPECT_LT(whole.points[i].y, after.points[i].y - 0.04);
  EXPECT_EQ(hand.refuses(PullTarget{CurveId{7}, hand.view, {0, 0}, {1, 1}, 0.3}).place, "curve");
  EXPECT_EQ(hand.refuses(PullTarget{CurveId{1}, hand.view, {0, 0}, {1, 1}, -0.3}).place, "reach");
}

TEST(TakeRegion, TheFrontAloneOrWhatLiesBehindToo) {
  DocumentHand hand;
  EXPECT_FALSE(hand.refuses(TakeRegion{Reach::front, {}}).what.empty()) << "nothing was begun";
  hand.does(BeginDeformer{"up", articulation::Mode::automatic, {}, 0, 1});
  hand.does(TakeRegion{Reach::front, {}});
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  EXPECT_EQ(hand.document().pending->sketch.reach, Reach::front);
  EXPECT_EQ(hand.refuses(TakeRegion{{}, 3}).place, "piece");
  hand.does(TakeRegion{Reach::through, {}});
  EXPECT_EQ(hand.document().pending->sketch.reach, Reach::through);
}

TEST(ChangeDeformer, AnotherRangeBuildsItAgain) {
  DocumentHand hand;
  sketch(hand, "up", 0.3);
  const auto built = hand.document().model->deformers->deformers()[0];
  hand.does(ChangeDeformer{"up", {}, {}, -1.0, 1.5});
  EXPECT_NE(only(hand).vertices().data(), built->vertices().data());
  const auto again = articulation::build_deformer(only(hand).sketch(), *make_canvas(*hand.document().model).value());
  EXPECT_EQ((*again)->strain().stretch, only(hand).strain().stretch) << "what a file would be read as";
}

class Correction : public testing::Test {
 protected:
  Correction() {
    sketch(hand, "up", 0.25);
    hand.does(BeginDeformer{"aside", articulation::Mode::translate, {}, 0, 1});
    hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.7)});
    hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.3)});
    hand.does(SketchCurve{CurveRole::reference, hand.view, hand.line(0, -0.2, 0, 0.2)});
    hand.does(SketchCurve{CurveRole::target, hand.view, hand.line(0.15, -0.2, 0.15, 0.2)});
  }
  /// At up = aside = 1 the middle is brought down again.
  void correct() {
    hand.does(SetParameters{{{"up", 1}, {"aside", 1}}});
    hand.does(BeginCorrection{"both", {}});
    bring_down(hand);
  }
  DocumentHand hand;
};

TEST_F(Correction, IsThereWhereBothControlsComeTogetherAndNowhereElse) {
  const double alone_up = middle(posed(hand, {{"up", 1}}));
  const double alone_aside = middle(posed(hand, {{"aside", 1}}));
  const double together = middle(posed(hand, {{"up", 1}, {"aside", 1}}));
  correct();
  ASSERT_NE(hand.document().model->corrections, nullptr);
  EXPECT_EQ(hand.document().pending, nullptr);
  EXPECT_EQ(middle(posed(hand, {{"up", 1}})), alone_up);
  EXPECT_EQ(middle(posed(hand, {{"aside", 1}})), alone_aside);
  const double corrected = middle(posed(hand, {{"up", 1}, {"aside", 1}}));
  EXPECT_LT(corrected, together - 0.1);
  // Half of one control brings half of the correction.
  const double half = middle(posed(hand, {{"up", 1}, {"aside", 0.5}}));
  EXPECT_NEAR(half, 0.5 * (middle(posed(hand, {{"up", 1}})) + corrected), 0.02);
  // The few vertices that a solver asks for are where all of them are.
  const auto& rig = *hand.document().model->rig;
  const std::vector<std::uint32_t> some{7 * 15 + 7, 3};
  const auto bound = rig.bind(some);
  rig::Pose pose = hand.document().pose;
  std::vector<geometry::ModelPoint> few(2);
  bound->evaluate(pose, few);
  EXPECT_EQ(few[0].y, corrected);
  const std::vector<std::size_t> free{*rig::find_parameter(rig.parameters(), "up")};
  EXPECT_FALSE(bound->linearize(pose, free).has_value()) << "a product of two controls is not affine in one's range";
  hand.does(DeleteCorrection{"both"});
  EXPECT_EQ(hand.document().model->corrections, nullptr);
  EXPECT_EQ(middle(posed(hand, {{"up", 1}, {"aside", 1}})), together);
}

TEST_F(Correction, GoesAlongWithItsControls) {
  correct();
  const auto named = hand.state();
  hand.does(RenameDeformer{"up", "raise"});
  EXPECT_NE(hand.state(), named);
  EXPECT_EQ(hand.document().model->corrections->all()[0]->drawn.drivers[0].control, "raise");
  const double before = middle(posed(hand, {{"raise", 1}, {"aside", 1}}));
  // What it was drawn on has changed: it is built again from its strokes.
  hand.does(RedrawCurve{"aside", CurveRole::target, hand.view, hand.line(0.2, -0.2, 0.2, 0.2)});
  ASSERT_NE(hand.document().model->corrections, nullptr);
  EXPECT_NEAR(middle(posed(hand, {{"raise", 1}, {"aside", 1}})), before, 0.1);
  hand.does(DeleteDeformer{"aside"});
  EXPECT_EQ(hand.document().model->corrections, nullptr) << "without one of its controls it means nothing";
}

TEST_F(Correction, IsDrawnOnThePoseThatItCorrects) {
  EXPECT_EQ(hand.refuses(BeginCorrection{}).place, "drivers") << "all is at rest";
  hand.does(SetParameters{{{"up", 1}}});
  EXPECT_EQ(hand.refuses(BeginCorrection{}).place, "drivers") << "one control is no combination";
  hand.does(SetParameters{{{"aside", 1}}});
  EXPECT_EQ(hand.refuses(BeginCorrection{"up", {}}).place, "name");
  EXPECT_EQ(hand.refuses(BeginCorrection{"both", {{"up", 1}, {"sideways", 1}}}).place, "drivers/1");
  hand.refuses(BeginCorrection{"both", {{"up", 1}, {"aside", 0.5}}});
  hand.does(BeginCorrection{});
  EXPECT_EQ(hand.document().pending->sketch.name, "correction 1");
  EXPECT_EQ(hand.document().pending->drivers.size(), 2U);
  hand.refuses(DeleteDeformer{"up"});
  hand.refuses(RenameDeformer{"up", "raise"});
  hand.does(SetParameters{{{"up", 0.5}}});
  EXPECT_NE(hand.refuses(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)}).what.find("pose"),
            std::string::npos);
  hand.does(SetParameters{{{"up", 1}}});
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  hand.does(CancelDeformer{});
  EXPECT_EQ(hand.refuses(DeleteCorrection{"both"}).place, "correction");
}

TEST_F(Correction, IsDrawnAgainRenamedAndTakenBack) {
  correct();
  const double first = middle(posed(hand, {{"up", 1}, {"aside", 1}}));
  // Not as far down this time.
  hand.does(RedrawCurve{"both", CurveRole::target, hand.view, hand.line(-0.1, 0.15, 0.4, 0.15)});
  const double again = middle(posed(hand, {{"up", 1}, {"aside", 1}}));
  EXPECT_GT(again, first + 0.05);
  ASSERT_EQ(hand.document().model->corrections->size(), 1U) << "in place of the first, not beside it";
  EXPECT_EQ(hand.document().model->corrections->all()[0]->drawn.drivers.size(), 2U);
  EXPECT_EQ(hand.refuses(RenameDeformer{"both", "up"}).place, "to");
  EXPECT_EQ(hand.refuses(RenameDeformer{"both", ""}).place, "to");
  hand.does(RenameDeformer{"both", "cheek"});
  EXPECT_EQ(hand.document().model->corrections->all()[0]->drawn.sketch.name, "cheek");
  EXPECT_EQ(middle(posed(hand, {{"up", 1}, {"aside", 1}})), again) << "a name moves nothing";
  // A line off the model: said, and nothing changed.
  const auto state = hand.state();
  hand.refuses(RedrawCurve{"cheek", CurveRole::general, hand.view, {{1, 1}, {2, 1}, {2, 2}}});
  EXPECT_EQ(hand.state(), state);
  hand.does(DeleteCorrection{"cheek"});
  EXPECT_EQ(hand.document().model->corrections, nullptr);
}

TEST_F(Correction, ItsMirrorImageFollowsTheControlsOfTheOtherSide) {
  hand.does(RenameDeformer{"aside", "aside_L"});
  hand.does(MirrorDeformer{"aside_L", ""});
  hand.does(SetParameters{{{"up", 1}, {"aside_L", 1}}});
  hand.does(BeginCorrection{"corner_L", {}});
  bring_down(hand);
  const double left = middle(posed(hand, {{"up", 1}, {"aside_L", 1}}));
  const double bare = middle(posed(hand, {{"up", 1}, {"aside_R", 1}}));
  hand.does(MirrorDeformer{"corner_L", ""});
  ASSERT_EQ(hand.document().model->corrections->size(), 2U);
  const auto& other = hand.document().model->corrections->all()[1]->drawn;
  EXPECT_EQ(other.sketch.name, "corner_R");
  ASSERT_EQ(other.drivers.size(), 2U);
  EXPECT_EQ(other.drivers[0].control, "up") << "which has no side";
  EXPECT_EQ(other.drivers[1].control, "aside_R");
  EXPECT_EQ(middle(posed(hand, {{"up", 1}, {"aside_L", 1}})), left) << "the first is as it was";
  const double right = middle(posed(hand, {{"up", 1}, {"aside_R", 1}}));
  EXPECT_LT(right, bare - 0.1);
  EXPECT_NEAR(right, left, 0.02);
  EXPECT_EQ(hand.refuses(MirrorDeformer{"corner_L", ""}).place, "to") << "it is there already";
}

TEST(CommandText, NewCommandsComeBackAsTheyWereWritten) {
  const View view{{{0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 800}};
  const std::vector<Command> commands{
      BeginCorrection{"both of them", {{"up", 1}, {"a b", 0.25}}, articulation::Mode::rotate},
      DeleteCorrection{"both"},
      TakeRegion{Reach::front, 2},
      TakeRegion{{}, 0},
      DrawBetween{"up", 0.25, view, {{1, 2}, {3, 4.5}}},
      DeleteBetween{"up", 0.25},
      PullBetween{"up", 1, view, {1, 2}, {3, -4}, 0},
      PullTarget{CurveId{3}, view, {1, 2}, {3, -4}, 0.5},
      ChangeDeformer{"up", {}, {}, -1.0, {}, {}, Reach::front, 1}};
  for (const Command& command : commands) {
    const auto again = parse_command(to_text(command));
    ASSERT_TRUE(again.ok()) << to_text(command) << ": " << again.error().line();
    EXPECT_TRUE(*again == command) << to_text(command);
  }
}

}  // namespace
}  // namespace penpose::document
