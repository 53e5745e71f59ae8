#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "core/document/features/feature_curves.h"
#include "core/drawing/editor.h"
#include "tests/support/document_hand.h"

// A face that is drawn over the built-in head, a line at a time.

namespace penpose::document {
namespace {

using tests::DocumentHand;

class FaceHand : public DocumentHand {
 public:
  FaceHand() : DocumentHand(make_document(character::make_demo_head().value())) {
    const Model& model = *document().model;
    features_ = feature_curves_of(model, intent::measure_whole_model(*model.rig), {}).value().curves;
    view = drawing::opening_view(document());
  }

  /// The curve of a feature as the view shows it with these values, moved by some px.
  [[nodiscard]] std::vector<PxPoint> curve(const std::string& feature,
                                           const std::vector<std::pair<const char*, double>>& values,
                                           PxPoint by = {0, 0}) const {
    const rig::Rig& rig = *document().model->rig;
    rig::Pose pose = rig::rest_pose(rig);
    for (const auto& [name, value] : values) pose[rig::find_parameter(rig.parameters(), name).value()] = value;
    std::vector<geometry::ModelPoint> places(rig.vertex_count());
    rig.evaluate(pose, places);
    const auto camera = geometry::Camera::make(view.camera, view.viewport).value();
    std::vector<PxPoint> out;
    for (const portrait::FeatureCurve& one : features_) {
      if (one.name != feature) continue;
      for (const posing::CurvePoint& point : one.points) {
        geometry::ModelPoint p(0);
        for (std::size_t k = 0; k < 3; ++k) p += places[point.vertex[k]] * point.weight[k];
        out.push_back(*camera.project(p) + by);
      }
    }
    EXPECT_GT(out.size(), 1U) << feature;
    return out;
  }
  void draws(const std::string& feature, const std::vector<std::pair<const char*, double>>& values) {
    does(DrawFaceLine{{view, curve(feature, values)}});
  }
  [[nodiscard]] const FaceLine& last() const { return document().face->lines.back(); }

 private:
  std::vector<portrait::FeatureCurve> features_;
};

const std::vector<std::pair<const char*, double>> k_smile{{"mouth_corner_L", 0.8}, {"mouth_corner_R", 0.8}};

TEST(FaceCommands, ASmileDrawnOverTheMouthIsTakenAsOneLineAtATime) {
  FaceHand hand;
  hand.draws("lip_upper", k_smile);
  EXPECT_NE(hand.last().feature.find("lip_upper"), std::string::npos) << hand.last().feature;
  hand.draws("lip_lower", k_smile);
  EXPECT_NE(hand.last().feature.find("lip_lower"), std::string::npos) << hand.last().feature;
  EXPECT_NEAR(hand.value("mouth_corner_L"), 0.8, 0.25);
  EXPECT_NEAR(hand.value("mouth_corner_R"), 0.8, 0.25);
  EXPECT_NEAR(hand.value("brow_inner_L"), 0.0, 0.02);
}

TEST(FaceCommands, AMouthOfOneLineIsShutAndSmiles) {
  FaceHand hand;
  hand.draws("lip_upper_inner", k_smile);
  EXPECT_NEAR(hand.value("mouth_corner_L"), 0.8, 0.3);
  EXPECT_NEAR(hand.value("mouth_corner_R"), 0.8, 0.3);
  EXPECT_NEAR(hand.value("jaw"), 0.0, 0.1);
  hand.does(ClearCurves{});
  hand.does(ResetParameters{});
  // A deeper bow than lips make.
  auto line = hand.curve("lip_upper_inner", {});
  const double middle = 0.5 * (line.front().x + line.back().x), half = 0.5 * std::abs(line.back().x - line.front().x);
  for (PxPoint& p : line) {
    const double share = (p.x - middle) / half;
    p.x = middle + 1.25 * (p.x - middle);
    p.y += 4.0 - 34.0 * share * share;
  }
  hand.does(DrawFaceLine{{hand.view, line}});
  EXPECT_NE(hand.last().feature.find("inner"), std::string::npos) << hand.last().feature;
  EXPECT_GT(hand.value("mouth_corner_L"), 0.5);
  EXPECT_GT(hand.value("mouth_corner_R"), 0.5);
}

TEST(FaceCommands, WhatIsNotDrawnStaysAsItIs) {
  FaceHand hand;
  hand.does(SetParameters{{{"brow_inner_L", 0.6}}});
  hand.draws("lip_upper", k_smile);
  EXPECT_EQ(hand.value("brow_inner_L"), 0.6);
  // So does what is set between two lines.
  hand.does(SetParameters{{{"brow_inner_R", 0.3}}});
  hand.draws("lip_lower", k_smile);
  EXPECT_EQ(hand.value("brow_inner_L"), 0.6);
  EXPECT_EQ(hand.value("brow_inner_R"), 0.3);
}

TEST(FaceCommands, ALineOfOneSideLeavesTheOtherSideAlone) {
  FaceHand hand;
  hand.draws("brow_R", {{"brow_inner_R", 0.8}, {"brow_outer_R", 0.8}});
  EXPECT_NEAR(hand.value("brow_inner_R"), 0.8, 0.3);
  for (const char* name : {"brow_inner_L", "brow_outer_L"}) EXPECT_EQ(hand.value(name), 0.0) << name;
}

TEST(FaceCommands, ALineThatIsDrawnAgainTakesThePlaceOfTheFirst) {
  FaceHand hand;
  hand.draws("brow_R", {{"brow_inner_R", 0.9}, {"brow_outer_R", 0.9}});
  hand.draws("lip_upper_inner", k_smile);
  hand.draws("brow_R", {{"brow_inner_R", -0.5}, {"brow_outer_R", -0.5}});
  ASSERT_EQ(hand.document().face->lines.size(), 2U);
  EXPECT_EQ(hand.last().feature, "brow_R");
  EXPECT_LT(hand.value("brow_inner_R"), -0.2);
  EXPECT_NEAR(hand.value("mouth_corner_L"), 0.8, 0.3) << "the mouth stays";
}

TEST(FaceCommands, TheOtherHalfOfALineGoesOnWithIt) {
  FaceHand hand;
  const auto brow = hand.curve("brow_R", {{"brow_inner_R", 0.9}, {"brow_outer_R", 0.9}});
  const auto middle = brow.begin() + static_cast<std::ptrdiff_t>(brow.size() / 2);
  hand.does(DrawFaceLine{{hand.view, {brow.begin(), middle + 1}}});
  hand.does(DrawFaceLine{{hand.view, {middle, brow.end()}}});
  EXPECT_EQ(hand.document().face->lines.size(), 2U);
}

TEST(FaceCommands, ALineIsWhatTheArtistSaysItIs) {
  FaceHand hand;
  hand.draws("lip_upper", k_smile);
  const CurveId id = hand.last().id;
  hand.does(NameFaceLine{id, "lip_lower", false});
  EXPECT_EQ(hand.last().feature, "lip_lower");
  // It stays that while others are drawn.
  hand.draws("brow_L", {});
  EXPECT_EQ(hand.document().face->lines.front().feature, "lip_lower");
  hand.does(NameFaceLine{id, {}, true});
  EXPECT_EQ(hand.document().face->lines.front().feature, "");
  EXPECT_NEAR(hand.value("mouth_corner_L"), 0.0, 0.02);
  hand.does(NameFaceLine{id, {}, false});
  EXPECT_NE(hand.document().face->lines.front().feature.find("lip"), std::string::npos);

  EXPECT_EQ(hand.refuses(NameFaceLine{CurveId{99}, {}, true}).place, "curve");
  EXPECT_NE(hand.refuses(NameFaceLine{id, "brow_l", false}).remedy.find("brow_L"), std::string::npos);
}

TEST(FaceCommands, ALineWhoseFormAloneCountsIsMovedToItsFeature) {
  FaceHand hand;
  std::vector<PxPoint> line = hand.curve("lip_upper_inner", k_smile, {9, 30});
  hand.does(DrawFaceLine{{hand.view, line}});
  const CurveId id = hand.last().id;
  hand.does(NameFaceLine{id, "lip_upper_inner", false, true});
  EXPECT_EQ(hand.last().feature, "lip_upper_inner");
  EXPECT_GT(hand.value("mouth_corner_L"), 0.3);
  EXPECT_GT(hand.value("mouth_corner_R"), 0.3);
  EXPECT_NEAR(hand.value("jaw"), 0.0, 0.1);
  const auto middle = [](const std::vector<PxPoint>& points) {
    PxPoint sum{0, 0};
    for (const PxPoint& p : points) sum = sum + p;
    return sum * (1.0 / static_cast<double>(points.size()));
  };
  const PxPoint there = middle(hand.last().line), at_rest = middle(hand.curve("lip_upper_inner", {}));
  EXPECT_NEAR(there.x, at_rest.x, 1.0);
  EXPECT_NEAR(there.y, at_rest.y, 1.0);
}

TEST(FaceCommands, ALineThatIsDeletedCountsNoMoreAndTheLastOneLeavesThePose) {
  FaceHand hand;
  hand.draws("brow_L", {{"brow_inner_L", 0.8}});
  const double brow = hand.value("brow_inner_L");
  hand.draws("lip_upper", k_smile);
  hand.does(DeleteCurve{hand.last().id});
  EXPECT_EQ(hand.document().face->lines.size(), 1U);
  EXPECT_NEAR(hand.value("brow_inner_L"), brow, 1e-9);
  EXPECT_NEAR(hand.value("mouth_corner_L"), 0.0, 0.02);
  hand.does(EraseCurves{{hand.view, hand.curve("brow_L", {{"brow_inner_L", 0.8}})}});
  EXPECT_EQ(hand.document().face, nullptr);
  EXPECT_NEAR(hand.value("brow_inner_L"), brow, 1e-9);
}

TEST(FaceCommands, ACloserLookGoesOnAndAnotherSideBeginsAnew) {
  FaceHand hand;
  hand.draws("brow_L", {{"brow_inner_L", 0.8}});
  const View first = hand.view;
  hand.view.camera.vertical_fov_degrees *= 0.6;
  hand.draws("lip_upper", k_smile);
  ASSERT_EQ(hand.document().face->lines.size(), 2U);
  EXPECT_EQ(hand.document().face->view, first);
  EXPECT_GT(hand.value("mouth_corner_L"), 0.3);
  hand.view = first;
  const auto from = hand.view.camera.eye - hand.view.camera.look_at;
  hand.view.camera.eye = hand.view.camera.look_at + geometry::ModelVector(0.6 * from.z, from.y, 0.8 * from.z);
  hand.draws("brow_L", {});
  EXPECT_EQ(hand.document().face->lines.size(), 1U);
  EXPECT_GT(hand.value("mouth_corner_L"), 0.3) << "what was drawn before stays";
}

TEST(FaceCommands, ADrawingBelongsToItsMoment) {
  FaceHand hand;
  hand.draws("lip_upper", k_smile);
  hand.does(SetKey{0, ""});
  hand.does(GoToTime{1});
  hand.draws("brow_L", {});
  EXPECT_EQ(hand.document().face->lines.size(), 1U);
}

TEST(FaceCommands, ProportionsOfTheNeutralFaceAreNoExpression) {
  const PxPoint lower{0, 14};
  FaceHand hand;
  const std::vector<const char*> drawn{"lip_upper", "lip_lower", "brow_L", "brow_R"};
  for (const char* name : drawn) hand.does(DrawFaceLine{{hand.view, hand.curve(name, {}, lower)}});
  hand.does(SetNeutral{});
  EXPECT_EQ(hand.document().face, nullptr);
  for (const char* name : {"jaw", "mouth_corner_L", "brow_inner_L"}) EXPECT_EQ(hand.value(name), 0.0) << name;
  for (const char* name : drawn) hand.does(DrawFaceLine{{hand.view, hand.curve(name, k_smile, lower)}});
  EXPECT_NEAR(hand.value("mouth_corner_L"), 0.8, 0.25);
  EXPECT_NEAR(hand.value("jaw"), 0.0, 0.1);
  hand.does(SetNeutral{false});
  EXPECT_EQ(hand.document().neutral, nullptr);
  EXPECT_EQ(hand.refuses(SetNeutral{false}).place, "on");
  hand.does(ClearCurves{});
  EXPECT_EQ(hand.refuses(SetNeutral{}).place, "on");
}

TEST(FaceCommands, OnAModelWithoutFeaturesALineIsAReferenceThenItsTarget) {
  DocumentHand hand;
  hand.does(DrawFaceLine{{hand.view, hand.line(-0.5, 0, 0.5, 0)}});
  ASSERT_EQ(hand.document().curves.size(), 1U);
  EXPECT_FALSE(hand.document().curves.front()->target);
  hand.does(DrawFaceLine{{hand.view, hand.line(-0.5, 0.1, 0.5, 0.1)}});
  ASSERT_EQ(hand.document().curves.size(), 1U);
  EXPECT_TRUE(hand.document().curves.front()->target);
}

TEST(FaceCommands, BadLinesAreRefused) {
  FaceHand hand;
  EXPECT_EQ(hand.refuses(DrawFaceLine{{hand.view, {}}}).place, "line");
  EXPECT_EQ(hand.refuses(DrawFaceLine{{hand.view, {{5, 5}, {5, 5}}}}).place, "line");
  View none = hand.view;
  none.camera.look_at = none.camera.eye;
  EXPECT_EQ(hand.refuses(DrawFaceLine{{none, {{5, 5}, {50, 5}}}}).place.substr(0, 4), "view");
}

}  // namespace
}  // namespace penpose::document
