#include <gtest/gtest.h>
#include <limits>

#include "core/document/commands/apply.h"
#include "core/document/drawing/pose_problem.h"
#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

constexpr CurveId k_first{1};
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

/// Three points of the upper half of the sheet, which `lift` moves.
std::vector<mesh::MeshPoint> some_points() { return {{300, {1, 0, 0}}, {315, {0.25, 0.25, 0.5}}, {340, {0, 0, 1}}}; }

DocumentHand placed() {
  DocumentHand hand;
  hand.does(LockParameters{{"base.rx", "base.ry", "base.rz"}, true});
  hand.does(PlaceCurve{some_points(), false});
  return hand;
}

/// Where the sheet's own controls bring the points of the first curve.
std::vector<geometry::ModelPoint> reached(const DocumentHand& hand, double lift) {
  Document posed = hand.document();
  posed.pose[*rig::find_parameter(posed.model->rig->parameters(), "lift")] = lift;
  return positions_of(posed, find_curve(posed, k_first)->points);
}

TEST(ApplyPlaced, ACurveHasThePointsThatWereGiven) {
  const auto hand = placed();
  ASSERT_NE(find_curve(hand.document(), k_first), nullptr);
  EXPECT_EQ(find_curve(hand.document(), k_first)->points, some_points());
}

TEST(ApplyPlaced, AConstraintStaysWhereItIsNow) {
  DocumentHand hand;
  hand.does(PlaceCurve{some_points(), true});
  const PoseCurve& curve = *find_curve(hand.document(), k_first);
  EXPECT_EQ(curve.role, PoseCurveRole::constraint);
  EXPECT_EQ(curve.kept, positions_of(hand.document(), some_points()));
}

TEST(ApplyPlaced, ATargetSolvesNothingUntilItIsAsked) {
  auto hand = placed();
  const auto pose = hand.document().pose;
  hand.does(PlaceTarget{k_first, reached(hand, 0.6)});
  EXPECT_EQ(hand.document().pose, pose);
}

TEST(ApplyPlaced, EveryWayOfSolvingReachesWhatCanBeReached) {
  for (const SolvePose& solve : {SolvePose{Preset::exact}, SolvePose{Preset::paper}, SolvePose{}}) {
    auto hand = placed();
    hand.does(PlaceTarget{k_first, reached(hand, 0.6)});
    hand.does(solve);
    EXPECT_NEAR(hand.value("lift"), 0.6, solve.preset == Preset::paper ? 0.05 : 0.002)
        << static_cast<int>(solve.preset);
  }
}

TEST(ApplyPlaced, ALineDrawnLaterDoesNotForgetWhatIsKnown) {
  auto hand = placed();
  hand.does(PlaceTarget{k_first, reached(hand, 0.6)});
  hand.does(SolvePose{});
  hand.does(DrawReference{hand.view, hand.line(-0.5, -0.5, 0.5, -0.5)});
  hand.does(DrawTarget{CurveId{2}, hand.view, hand.line(-0.5, -0.55, 0.5, -0.55), {}});
  EXPECT_NEAR(hand.value("lift"), 0.6, 0.02);
}

TEST(ApplyPlaced, WhatIsKnownHasNoLineToDrawOver) {
  auto hand = placed();
  hand.does(PlaceTarget{k_first, reached(hand, 0.6)});
  EXPECT_EQ(hand.refuses(OversketchTarget{k_first, hand.view, hand.line(0, 0, 0.5, 0)}).place, "curve");
  EXPECT_EQ(hand.refuses(DragTarget{k_first, {5, 5}}).place, "curve");
  EXPECT_EQ(hand.refuses(PullTarget{k_first, hand.view, {5, 5}, {1, 1}, 0.1}).place, "curve");
  hand.does(DrawTarget{k_first, hand.view, hand.line(-0.5, 0.5, 0.5, 0.6), {}});
  EXPECT_FALSE(find_curve(hand.document(), k_first)->target->line.empty());
}

TEST(ApplyPlaced, PointsThatCannotBeAreRefused) {
  auto hand = placed();
  EXPECT_EQ(hand.refuses(PlaceCurve{}).place, "points");
  const auto triangles = static_cast<std::uint32_t>(hand.document().model->mesh->triangle_count());
  EXPECT_EQ(hand.refuses(PlaceCurve{{{0, {1, 0, 0}}, {triangles, {1, 0, 0}}}, false}).place, "points/1");
  EXPECT_EQ(hand.refuses(PlaceCurve{{{0, {0.5, 0.6, 0}}}, false}).place, "points/0");
  EXPECT_EQ(hand.refuses(PlaceCurve{{{0, {2, -1, 0}}}, false}).place, "points/0");
  EXPECT_EQ(hand.refuses(PlaceCurve{{{0, {k_nan, 1, 0}}}, true}).place, "points/0");
  EXPECT_EQ(hand.refuses(PlaceTarget{k_first, {{0, 0, 0}}}).place, "points");
  EXPECT_EQ(hand.refuses(PlaceTarget{k_first, {{0, 0, 0}, {0, k_nan, 0}, {0, 0, 0}}}).place, "points/1");
  EXPECT_EQ(hand.refuses(PlaceTarget{k_first, {{0, 0, 1e16}, {0, 0, 0}, {0, 0, 0}}}).place, "points/0");
  EXPECT_EQ(hand.refuses(PlaceTarget{CurveId{9}, {}}).place, "curve");
  hand.does(PlaceCurve{some_points(), true});
  EXPECT_EQ(hand.refuses(PlaceTarget{CurveId{2}, reached(hand, 0)}).place, "curve");
}

TEST(ApplyPlaced, ManyKnownTargetsAreAllAskedFor) {
  DocumentHand hand;
  for (std::uint32_t i = 1; i <= 2 * k_most_pairs; ++i) {
    hand.does(PlaceCurve{some_points(), false});
    hand.does(PlaceTarget{CurveId{i}, positions_of(hand.document(), some_points())});
  }
  EXPECT_EQ(pose_problem(hand.document()).pairs.size(), 2 * k_most_pairs);
  EXPECT_EQ(intent_problem(hand.document()).known.size(), 2 * k_most_pairs);
}

}  // namespace
}  // namespace penpose::document
