#include <algorithm>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "core/document/features/feature_curves.h"
#include "core/document/features/feature_near.h"
#include "core/drawing/editor.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "tests/support/document_hand.h"

// Features of the built-in head, corrected.

namespace penpose::document {
namespace {

using geometry::ModelPoint;
using tests::DocumentHand;

/// The head without the names of its lines, so that features are found by its shape.
Model nameless_head() {
  Model model = character::make_demo_head().value();
  model.curves.clear();
  return model;
}

class FeatureHand : public DocumentHand {
 public:
  FeatureHand() : FeatureHand(character::make_demo_head().value()) {}
  explicit FeatureHand(Model model) : DocumentHand(make_document(std::move(model))) {
    view = drawing::opening_view(document());
  }

  [[nodiscard]] FeatureCurves features() const {
    const Model& model = *document().model;
    return feature_curves_of(model, intent::measure_whole_model(*model.rig), {}).value();
  }
  /// Where a feature runs; empty: the face has none of that name that is sure.
  [[nodiscard]] std::vector<ModelPoint> places(const std::string& name) const {
    for (const portrait::FeatureCurve& curve : features().curves) {
      if (curve.name == name) return positions_of(*document().model, document().pose, curve);
    }
    return {};
  }
  /// A line over a feature as it is seen, moved by some px.
  [[nodiscard]] std::vector<PxPoint> over(const std::string& name, PxPoint by) const {
    const auto camera = geometry::Camera::make(view.camera, view.viewport).value();
    std::vector<PxPoint> out;
    for (const ModelPoint& p : places(name)) out.push_back(*camera.project(p) + by);
    EXPECT_GT(out.size(), 1U) << name;
    return out;
  }
};

/// How far the ends of a line went up, m.
double rise(const std::vector<ModelPoint>& before, const std::vector<ModelPoint>& after) {
  return 0.5 * (after.front().y - before.front().y + after.back().y - before.back().y);
}

TEST(FeatureCommands, ALineAlongAFeatureMovesTheNearestOneThere) {
  FeatureHand hand;
  const auto before = hand.places("brow_L");
  const auto other = hand.places("brow_R");
  hand.does(DrawFeature{hand.view, hand.over("brow_L", {0, -8}), {}});
  const auto after = hand.places("brow_L");
  EXPECT_GT(rise(before, after), 0.0);
  EXPECT_EQ(hand.places("brow_R"), other);
  // It runs as it did before, whichever way it was drawn.
  auto back = hand.over("brow_L", {0, 0});
  std::reverse(back.begin(), back.end());
  hand.does(DrawFeature{hand.view, back, {}});
  const auto again = hand.places("brow_L");
  EXPECT_LT(geometry::distance(again.front(), after.front()), geometry::distance(again.front(), after.back()));
  ASSERT_TRUE(hand.undo().ok());
  ASSERT_TRUE(hand.undo().ok());
  EXPECT_EQ(hand.places("brow_L"), before);
  EXPECT_TRUE(hand.document().model->features.empty());
}

TEST(FeatureCommands, ALineOverNothingOrOverLipsThatTouchHasToBeNamed) {
  FeatureHand hand;
  // Across the forehead, upright.
  const auto brow = hand.over("brow_L", {0, 0});
  const PxPoint from{0.5 * (brow.front().x + hand.over("brow_R", {}).back().x), brow.front().y - 90};
  const std::vector<PxPoint> upright{from, from + PxPoint{0, 60}};
  EXPECT_EQ(hand.refuses(DrawFeature{hand.view, upright, {}}).place, "feature");
  const auto mouth = hand.over("lip_upper_inner", {0, 0});
  EXPECT_EQ(hand.refuses(DrawFeature{hand.view, mouth, {}}).place, "feature");
  hand.does(DrawFeature{hand.view, upright, "scar"});
  EXPECT_FALSE(hand.places("scar").empty());
  // It was drawn downwards; features run up, or to the face's own left.
  EXPECT_LT(hand.places("scar").front().y, hand.places("scar").back().y);
}

TEST(FeatureCommands, WhatTheFaceDoesNotHaveIsNotFoundAndCanBeTakenBack) {
  FeatureHand hand(nameless_head());
  const auto found = hand.places("lip_upper_inner");
  ASSERT_FALSE(found.empty());
  hand.does(PlaceFeature{"lip_upper_inner", {}});
  EXPECT_TRUE(hand.places("lip_upper_inner").empty());
  const auto names = nameable_features(*hand.document().model, hand.features());
  EXPECT_EQ(std::count(names.begin(), names.end(), "lip_upper_inner"), 1) << "it can be drawn all the same";
  hand.does(FeatureAsFound{"lip_upper_inner"});
  EXPECT_EQ(hand.places("lip_upper_inner"), found);
  EXPECT_EQ(hand.refuses(FeatureAsFound{"lip_upper_inner"}).place, "feature");
}

TEST(FeatureCommands, ALineOfTheFaceIsWhereItsFeatureIsAndMovesNothing) {
  FeatureHand hand;
  const auto before = hand.places("brow_L");
  const rig::Pose rest = hand.document().pose;
  hand.does(DrawFaceLine{{hand.view, hand.over("brow_L", {0, -14})}});
  ASSERT_NE(hand.document().pose, rest) << "it was read as a wish";
  hand.does(LineIsFeature{hand.document().face->lines.front().id, "brow_L"});
  EXPECT_EQ(hand.document().pose, rest);
  EXPECT_EQ(hand.document().face, nullptr);
  EXPECT_GT(rise(before, hand.places("brow_L")), 0.0);
  // What is drawn where the feature now is asks for nothing.
  hand.does(DrawFaceLine{{hand.view, hand.over("brow_L", {0, 0})}});
  EXPECT_NEAR(hand.value("brow_inner_L") + hand.value("brow_outer_L"), 0.0, 0.1);
}

TEST(FeatureCommands, AReferenceIsAFeatureAndGoes) {
  FeatureHand hand;
  hand.does(DrawReference{{hand.view, hand.over("brow_R", {0, -6})}});
  const CurveId id{hand.document().last_curve};
  const auto points = find_curve(hand.document(), id)->points;
  hand.does(LineIsFeature{id, "brow_R"});
  EXPECT_EQ(find_curve(hand.document(), id), nullptr);
  const NamedCurve* corrected = find_correction(*hand.document().model, "brow_R");
  ASSERT_NE(corrected, nullptr);
  EXPECT_EQ(corrected->points.size(), points.size());
  EXPECT_EQ(hand.refuses(LineIsFeature{id, "brow_R"}).place, "curve");
}

TEST(FeatureCommands, ADrawingThatIsThereIsReadByTheCorrection) {
  FeatureHand hand;
  hand.does(DrawFaceLine{{hand.view, hand.over("brow_L", {0, -14})}});
  const double raised = hand.value("brow_inner_L") + hand.value("brow_outer_L");
  ASSERT_GT(raised, 0.3);
  // The brow was there already.
  FeatureHand at_rest;
  at_rest.does(DrawFeature{at_rest.view, at_rest.over("brow_L", {0, -14}), "brow_L"});
  hand.does(PlaceFeature{"brow_L", at_rest.document().model->features.front().points});
  EXPECT_LT(hand.value("brow_inner_L") + hand.value("brow_outer_L"), 0.6 * raised);
}

TEST(FeatureCommands, PointsHaveToBeOnTheMesh) {
  FeatureHand hand;
  EXPECT_EQ(hand.refuses(PlaceFeature{"", {{0, {1, 0, 0}}, {1, {1, 0, 0}}}}).place, "feature");
  EXPECT_EQ(hand.refuses(PlaceFeature{"brow_L", {{0, {1, 0, 0}}}}).place, "points");
  EXPECT_EQ(hand.refuses(PlaceFeature{"brow_L", {{0, {1, 0, 0}}, {4000000000U, {1, 0, 0}}}}).place, "points/1");
  EXPECT_EQ(hand.refuses(PlaceFeature{"brow_L", {{0, {1, 0, 0}}, {1, {1, 1, 0}}}}).place, "points/1");
}

TEST(FeatureCommands, AFileKeepsThem) {
  FeatureHand hand;
  hand.does(DrawFeature{hand.view, hand.over("brow_L", {0, -8}), {}});
  hand.does(PlaceFeature{"jaw", {}});
  const auto again = io::read_document(io::write_document(hand.document(), "a.glb").value(), "a.glb");
  ASSERT_TRUE(again.ok()) << again.error().line();
  ASSERT_EQ(again->model->features.size(), 2U);
  EXPECT_EQ(again->model->features.front().points, hand.document().model->features.front().points);
  EXPECT_EQ(again->model->features.back().name, "jaw");
  EXPECT_TRUE(again->model->features.back().points.empty());
  EXPECT_EQ(DocumentHasher()(*again).whole, hand.state().whole);
}

TEST(FeatureCommands, StayWithTheModelWhileControlsAreMade) {
  FeatureHand hand;
  hand.does(PlaceFeature{"jaw", {}});
  hand.does(BeginDeformer{"cheek", articulation::Mode::automatic, {}, 0, 1});
  hand.does(CancelDeformer{});
  const auto made = with_deformers(*hand.document().model, hand.document().model->deformers);
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->features.size(), 1U);
}

}  // namespace
}  // namespace penpose::document
