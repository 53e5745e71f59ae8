#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

constexpr CurveId k_first{1};
constexpr CurveId k_second{2};

/// The sheet with its joint locked, so that the shapes alone answer a curve.
DocumentHand shapes_only() {
  DocumentHand hand;
  hand.does(LockParameters{{"base.rx", "base.ry", "base.rz"}, true});
  return hand;
}

/// At `lift` 1 a point at height y goes up by 0.4 y, so that y 0.5 goes to 0.6 at 0.5.
void draw_lift(DocumentHand& hand, double to = 0.6) {
  hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  hand.does(DrawTarget{k_first, hand.view, hand.line(-0.5, to, 0.5, to), {}});
}

double mean_y(const std::vector<geometry::ModelPoint>& points) {
  double sum = 0;
  for (const auto& p : points) sum += p.y;
  return sum / static_cast<double>(points.size());
}

TEST(ApplyPosing, AReferenceLiesOnTheSurfaceAndMovesNothing) {
  DocumentHand hand;
  const auto pose = hand.document().pose;
  hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  ASSERT_EQ(hand.document().curves.size(), 1U);
  const PoseCurve& curve = *hand.document().curves[0];
  EXPECT_EQ(curve.id, k_first);
  EXPECT_EQ(curve.points.size(), k_pose_curve_points);
  EXPECT_FALSE(curve.target.has_value());
  EXPECT_EQ(hand.document().pose, pose);
}

TEST(ApplyPosing, ThePoseGoesToTheTarget) {
  auto hand = shapes_only();
  draw_lift(hand);
  EXPECT_NEAR(hand.value("lift"), 0.5, 0.05);
  EXPECT_NEAR(hand.value("lean"), 0, 0.05);
  const DrawnTarget& target = *find_curve(hand.document(), k_first)->target;
  EXPECT_EQ(target.line.size(), k_line_points);
  EXPECT_EQ(target.points.size(), k_pose_curve_points);
}

TEST(ApplyPosing, ATargetDrawnBackwardsIsTheSameTarget) {
  auto hand = shapes_only();
  draw_lift(hand);
  const double lift = hand.value("lift");
  hand.does(ResetParameters{});
  auto line = hand.line(-0.5, 0.6, 0.5, 0.6);
  std::reverse(line.begin(), line.end());
  hand.does(DrawTarget{k_first, hand.view, line, {}});
  EXPECT_NEAR(hand.value("lift"), lift, 1e-6);
}

TEST(ApplyPosing, ATargetDrawnAgainReplacesTheOneBefore) {
  auto hand = shapes_only();
  draw_lift(hand);
  hand.does(DrawTarget{k_first, hand.view, hand.line(-0.5, 0.65, 0.5, 0.65), {}});
  EXPECT_EQ(hand.document().curves.size(), 1U);
  EXPECT_NEAR(hand.value("lift"), 0.75, 0.05);
}

TEST(ApplyPosing, LockedParametersDoNotMove) {
  auto hand = shapes_only();
  hand.does(SetParameters{{{"lift", 0.125}, {"base.rx", 0.01}}});
  hand.does(LockParameters{{"lift"}, true});
  draw_lift(hand, 0.7);
  EXPECT_EQ(hand.value("lift"), 0.125);
  EXPECT_EQ(hand.value("base.rx"), 0.01);
  hand.does(LockParameters{{"lean"}, true});
  const auto pose = hand.document().pose;
  hand.does(SolvePose{});
  EXPECT_EQ(hand.document().pose, pose) << "with nothing free nothing moves, and nothing fails";
}

TEST(ApplyPosing, APinHoldsAgainstATarget) {
  auto free = shapes_only();
  draw_lift(free, 0.7);
  auto pinned = shapes_only();
  for (const double x : {-0.4, -0.2, 0.0, 0.2, 0.4}) pinned.does(Pin{pinned.view, pinned.seen(x, 0.9)});
  ASSERT_EQ(pinned.document().curves.size(), 5U);
  EXPECT_EQ(pinned.document().curves[0]->points.size(), 1U);
  pinned.does(DrawReference{pinned.view, pinned.line(-0.5, 0.5, 0.5, 0.5)});
  pinned.does(DrawConstraint{pinned.view, pinned.line(-0.8, 0.9, 0.8, 0.9)});
  pinned.does(DrawTarget{CurveId{6}, pinned.view, pinned.line(-0.5, 0.7, 0.5, 0.7), {}});
  EXPECT_LT(pinned.value("lift"), 0.1 * free.value("lift"));
}

TEST(ApplyPosing, AKeptCurveStaysWhereItIsNow) {
  auto hand = shapes_only();
  draw_lift(hand);
  const double lift = hand.value("lift");
  hand.does(KeepCurve{k_first});
  const PoseCurve& kept = *find_curve(hand.document(), k_first);
  EXPECT_EQ(kept.role, PoseCurveRole::constraint);
  EXPECT_FALSE(kept.target.has_value());
  EXPECT_NEAR(mean_y(kept.kept), 0.6, 0.01);
  // A weaker pull elsewhere does not move it.
  hand.does(DrawReference{hand.view, hand.line(-0.1, 0.2, 0.1, 0.2)});
  hand.does(DrawTarget{k_second, hand.view, hand.line(-0.1, 0.2, 0.1, 0.2), {}});
  EXPECT_NEAR(hand.value("lift"), lift, 0.01);
  EXPECT_EQ(hand.refuses(KeepCurve{k_first}).place, "curve") << "it is a constraint already";
}

TEST(ApplyPosing, ADragMovesTheTargetAndThePoseFollows) {
  auto hand = shapes_only();
  draw_lift(hand);
  const auto before = *find_curve(hand.document(), k_first)->target;
  const double up_px = hand.seen(0, 0.6).y - hand.seen(0, 0.65).y;
  hand.does(DragTarget{k_first, {0, -up_px}});
  const auto& after = *find_curve(hand.document(), k_first)->target;
  EXPECT_NEAR(after.line[10].y, before.line[10].y - up_px, 1e-6);
  EXPECT_NEAR(hand.value("lift"), 0.75, 0.05);
  EXPECT_EQ(hand.refuses(DragTarget{k_first, {2e6, 0}}).place, "by");
}

TEST(ApplyPosing, AnOversketchReplacesAPartOfTheTarget) {
  auto hand = shapes_only();
  draw_lift(hand);
  const double before = hand.value("lift");
  hand.does(OversketchTarget{k_first, hand.view, hand.line(-0.1, 0.7, 0.5, 0.7)});
  const auto& target = *find_curve(hand.document(), k_first)->target;
  EXPECT_NEAR(target.points.front().y, 0.6, 0.02) << "what was not drawn over stays";
  EXPECT_NEAR(target.points.back().y, 0.7, 0.02);
  EXPECT_GT(hand.value("lift"), before + 0.05);
}

TEST(ApplyPosing, ATargetCanBeDrawnOverInAnotherView) {
  auto hand = shapes_only();
  hand.does(SetPressureWeighting{true});
  hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  std::vector<double> pressure;
  for (int i = 0; i <= 20; ++i) pressure.push_back(i < 10 ? 0.125 : 1.0);
  hand.does(DrawTarget{k_first, hand.view, hand.line(-0.5, 0.6, 0.5, 0.6), pressure});
  const auto before = *find_curve(hand.document(), k_first)->target;
  hand.view.camera.eye.x = 1.5;
  hand.view.viewport = {1200, 800};
  hand.does(OversketchTarget{k_first, hand.view, hand.line(0.2, 0.7, 0.5, 0.7)});
  const auto& after = *find_curve(hand.document(), k_first)->target;
  EXPECT_EQ(after.view, hand.view);
  EXPECT_NEAR(after.points.front().y, 0.6, 0.02);
  EXPECT_NEAR(after.points.back().y, 0.7, 0.03);
  EXPECT_NEAR(after.weights.front() / after.weights[20], before.weights.front() / before.weights[20], 0.02)
      << "how hard the rest was pressed is not forgotten";
}

TEST(ApplyPosing, PressureCountsOnlyWhenItShould) {
  const auto solved = [](bool weighting) {
    auto hand = shapes_only();
    hand.does(SetPressureWeighting{weighting});
    hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
    auto line = hand.line(-0.5, 0.6, 0.0, 0.6);
    const auto high = hand.line(0.0, 0.7, 0.5, 0.7);
    line.insert(line.end(), high.begin(), high.end());
    std::vector<double> pressure(line.size(), 0.02);
    std::fill(pressure.begin() + 21, pressure.end(), 1.0);
    hand.does(DrawTarget{k_first, hand.view, line, pressure});
    return hand.value("lift");
  };
  EXPECT_GT(solved(true), solved(false) + 0.1);
}

TEST(ApplyPosing, WhatASteadyHandMeansAShakyOneOnlyStraysBy) {
  const auto lifted = [](double unsteadiness) {
    auto hand = shapes_only();
    hand.does(SetHand{unsteadiness});
    hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
    const auto low = hand.seen(0, 0.5), high = hand.seen(0, 0.6);
    // Six px on a view 1000 px high.
    const double to = 0.5 + 0.1 * 6e-3 * hand.view.viewport.height / (low.y - high.y);
    hand.does(DrawTarget{k_first, hand.view, hand.line(-0.5, to, 0.5, to), {}});
    return hand.value("lift");
  };
  EXPECT_GT(lifted(0.25), 0.01);
  EXPECT_EQ(lifted(4), 0);
  auto hand = shapes_only();
  EXPECT_EQ(hand.refuses(SetHand{0.1}).place, "unsteadiness");
  EXPECT_EQ(hand.refuses(SetHand{5}).place, "unsteadiness");
  EXPECT_EQ(hand.refuses(SetHand{std::nan("")}).place, "unsteadiness");
}

TEST(ApplyPosing, TheEraserTakesWhatIsUnderItAndNothingElse) {
  auto hand = shapes_only();
  draw_lift(hand);
  hand.does(DrawReference{hand.view, hand.line(-0.5, -0.5, 0.5, -0.5)});
  hand.does(Pin{hand.view, hand.seen(0.8, -0.8)});
  EXPECT_EQ(hand.refuses(EraseCurves{hand.view, hand.line(-0.5, 0, 0.5, 0)}).place, "line");
  hand.does(EraseCurves{hand.view, hand.line(0, -0.7, 0, -0.3)});
  ASSERT_EQ(hand.document().curves.size(), 2U);
  EXPECT_EQ(find_curve(hand.document(), k_second), nullptr);
  hand.does(EraseCurves{hand.view, {hand.seen(0.8, -0.8)}});
  EXPECT_EQ(hand.document().curves.size(), 1U);
  const auto pose = hand.document().pose;
  hand.does(EraseCurves{hand.view, hand.line(0.3, 0.65, 0.3, 0.55)});
  EXPECT_TRUE(hand.document().curves.empty()) << "a target takes its reference with it";
  EXPECT_EQ(hand.document().pose, pose);
}

TEST(ApplyPosing, NumbersOfCurvesAreNeverUsedTwice) {
  DocumentHand hand;
  hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  hand.does(DeleteCurve{k_first});
  hand.does(DrawConstraint{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  EXPECT_EQ(hand.document().curves[0]->id, k_second);
  hand.does(ClearCurves{});
  hand.does(Pin{hand.view, hand.seen(0, 0)});
  EXPECT_EQ(hand.document().curves[0]->id, CurveId{3});
  Document last = hand.document();
  last.last_curve = 0xffffffffU;
  DocumentHand full(last);
  full.refuses(Pin{full.view, full.seen(0, 0)});
}

TEST(ApplyPosing, ACurveOfTheModelCanBeNamedAndDeleted) {
  DocumentHand hand;
  hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  hand.does(DrawReference{hand.view, hand.line(-0.5, -0.5, 0.5, -0.5)});
  hand.does(NameCurve{k_first, "brow"});
  hand.does(NameCurve{k_second, "brow"});
  ASSERT_EQ(hand.document().model->curves.size(), 1U) << "the second takes the place of the first";
  EXPECT_EQ(hand.document().model->curves[0].points, find_curve(hand.document(), k_second)->points);
  EXPECT_EQ(hand.refuses(NameCurve{k_first, ""}).place, "name");
  EXPECT_EQ(hand.refuses(NameCurve{k_first, "\xff"}).place, "name") << "no file could hold it";
  EXPECT_EQ(hand.refuses(NameCurve{CurveId{9}, "lip"}).place, "curve");
  hand.does(DeleteNamedCurve{"brow"});
  EXPECT_TRUE(hand.document().model->curves.empty());
  EXPECT_EQ(hand.refuses(DeleteNamedCurve{"brow"}).place, "name");
}

TEST(ApplyPosing, RefusesWhatCannotBe) {
  auto hand = shapes_only();
  const auto line = hand.line(-0.5, 0.5, 0.5, 0.5);
  View nowhere = hand.view;
  nowhere.camera.eye = nowhere.camera.look_at;
  EXPECT_EQ(hand.refuses(DrawReference{nowhere, line}).place, "view/eye");
  EXPECT_EQ(hand.refuses(Pin{nowhere, line[0]}).place, "view/eye");
  EXPECT_EQ(hand.refuses(EraseCurves{nowhere, line}).place, "view/eye");
  EXPECT_EQ(hand.refuses(DrawReference{hand.view, {}}).place, "line");
  EXPECT_EQ(hand.refuses(DrawReference{hand.view, {{1, 1}, {20, 5}}}).place, "line") << "it misses the sheet";
  EXPECT_EQ(hand.refuses(DrawConstraint{hand.view, {{1, 1}, {20, 5}}}).place, "line");
  EXPECT_EQ(hand.refuses(Pin{hand.view, {1, 1}}).place, "at");
  EXPECT_EQ(hand.refuses(DrawTarget{k_first, hand.view, line, {}}).place, "curve");
  EXPECT_EQ(hand.refuses(DeleteCurve{k_first}).place, "curve");
  EXPECT_EQ(hand.refuses(DeleteCurve{}).place, "curve");
  hand.does(DrawReference{hand.view, line});
  EXPECT_EQ(hand.refuses(OversketchTarget{k_first, hand.view, line}).place, "curve") << "no target yet";
  EXPECT_EQ(hand.refuses(DragTarget{k_first, {1, 1}}).place, "curve");
  EXPECT_EQ(hand.refuses(DrawTarget{k_first, hand.view, line, {0.5}}).place, "pressure");
  hand.refuses(DrawTarget{k_first, hand.view, {line[0]}, {}});
  hand.refuses(DrawTarget{k_first, hand.view, {line[0], line[0]}, {}});
  View behind = hand.view;
  behind.camera.look_at = {0, 0, 12};
  hand.refuses(DrawTarget{k_first, behind, line, {}});
  hand.does(DrawTarget{k_first, hand.view, line, {}});
  hand.refuses(OversketchTarget{k_first, behind, line});
  hand.does(Pin{hand.view, hand.seen(0, 0)});
  EXPECT_EQ(hand.refuses(DrawTarget{k_second, hand.view, line, {}}).place, "curve") << "a constraint has no target";
}

TEST(ApplyPosing, SolvingStartsFromThePoseAsItIs) {
  auto hand = shapes_only();
  hand.does(SolvePose{});
  EXPECT_EQ(hand.value("lift"), 0) << "without targets nothing moves";
  draw_lift(hand);
  const double solved = hand.value("lift");
  hand.does(ResetParameters{});
  hand.does(SolvePose{});
  EXPECT_NEAR(hand.value("lift"), solved, 1e-3);
}

TEST(ApplyPosing, AWorkspaceThatWasUsedGivesTheSameBits) {
  auto hand = shapes_only();
  draw_lift(hand);
  const Command command = DrawReference{hand.view, hand.line(-0.3, 0.4, 0.3, 0.1)};
  ApplyWorkspace fresh;
  const auto one = apply(hand.document(), command, fresh).value();
  hand.does(SetParameters{{{"lean", 0.5}}});
  hand.does(SetParameters{{{"lean", 0}}});
  hand.does(command);
  EXPECT_EQ(hand.document().curves.back()->points, one.curves.back()->points);
}

}  // namespace
}  // namespace penpose::document
