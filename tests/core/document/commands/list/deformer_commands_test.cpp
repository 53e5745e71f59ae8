#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using articulation::CurveRole;
using articulation::Mode;
using tests::DocumentHand;

std::vector<std::string> deformers(const DocumentHand& hand) {
  std::vector<std::string> names;
  const auto& set = hand.document().model->deformers;
  for (std::size_t i = 0; set && i < set->size(); ++i) names.push_back(set->parameters()[i].name);
  return names;
}

/// How far the middle of the sheet goes up when a deformer goes to 1.
double rise(DocumentHand& hand, const std::string& name) {
  Model model = *hand.document().model;
  model.pose = hand.document().pose;
  const auto before = posed_positions(model)[7 * 15 + 7].y;
  model.pose[*rig::find_parameter(model.rig->parameters(), name)] = 1;
  return posed_positions(model)[7 * 15 + 7].y - before;
}

TEST(ApplyArticulation, FourStrokesMakeADeformer) {
  DocumentHand hand;
  hand.sketch("up");
  EXPECT_EQ(deformers(hand), std::vector<std::string>{"up"});
  EXPECT_EQ(hand.document().pending, nullptr);
  EXPECT_EQ(hand.value("up"), 0);
  EXPECT_NEAR(rise(hand, "up"), 0.3, 0.1);
}

TEST(ApplyArticulation, TheStepsMustComeInTheirOrder) {
  DocumentHand hand;
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)}).place, "role");
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::target, hand.view, hand.line(-0.4, 0.3, 0.4, 0.3)}).place, "role");
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  EXPECT_EQ(hand.document().pending->sketch.name, "deformer 1") << "it needs no beginning of its own";
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::reference, hand.view, hand.line(-0.4, 0, 0.4, 0)}).place, "role");
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::target, hand.view, hand.line(-0.4, 0.3, 0.4, 0.3)}).place, "role");
  View other = hand.view;
  other.camera.eye.x = 1;
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::specific, other, hand.diamond(0.4)}).place, "view");
  other = hand.view;
  other.viewport.width = 900;
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::specific, other, hand.diamond(0.4)}).place, "view");
  hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)});
  hand.does(SketchCurve{CurveRole::reference, hand.view, hand.line(-0.4, 0, 0.4, 0)});
  hand.does(SketchCurve{CurveRole::target, hand.view, hand.line(-0.4, 0.3, 0.4, 0.3)});
  EXPECT_EQ(deformers(hand), std::vector<std::string>{"deformer 1"});
  EXPECT_FALSE(hand.document().model->deformers->deformers()[0]->sketch().reference.empty());
}

TEST(ApplyArticulation, ARegionThatHoldsNothingIsToldAtOnce) {
  DocumentHand hand;
  const std::vector<PxPoint> corner{{0, 0}, {30, 0}, {30, 30}, {0, 30}};
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::general, hand.view, corner}).place, "line");
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::general, hand.view, {}}).place, "line/general");
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::specific, hand.view, corner}).place, "line/core");
  hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)});
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::reference, hand.view, corner}).place, "line");
  hand.refuses(SketchCurve{CurveRole::target, hand.view, {{500, 500}}});
  const std::vector<PxPoint> endless(articulation::k_most_points + 1, PxPoint{500, 500});
  EXPECT_EQ(hand.refuses(SketchCurve{CurveRole::general, hand.view, endless}).place, "line");
}

TEST(ApplyArticulation, TheFirstRegionDrawnAgainBeginsAnew) {
  DocumentHand hand;
  hand.does(BeginDeformer{"up", Mode::rotate, {}, 0, 2});
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)});
  hand.view.camera.eye.x = 0.5;
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.7)});
  const articulation::Sketch& sketch = hand.document().pending->sketch;
  EXPECT_TRUE(sketch.specific.empty());
  EXPECT_EQ(sketch.camera, hand.view.camera);
  EXPECT_EQ(sketch.name, "up");
  EXPECT_EQ(sketch.mode, Mode::rotate);
  EXPECT_EQ(sketch.maximum, 2);
}

TEST(ApplyArticulation, TheWindowMayBeResizedBetweenTheSteps) {
  DocumentHand same;
  same.sketch("up");
  DocumentHand resized;
  resized.does(BeginDeformer{"up", Mode::automatic, {}, 0, 1});
  resized.does(SketchCurve{CurveRole::general, resized.view, resized.diamond(0.8)});
  resized.does(SketchCurve{CurveRole::specific, resized.view, resized.diamond(0.4)});
  resized.view.viewport = {1600, 700};
  resized.does(SketchCurve{CurveRole::target, resized.view, resized.line(-0.4, 0.3, 0.4, 0.3)});
  EXPECT_NEAR(rise(resized, "up"), rise(same, "up"), 1e-6);
  resized.view.viewport = {500, 500};
  resized.does(RedrawCurve{"up", CurveRole::target, resized.view, resized.line(-0.4, 0.2, 0.4, 0.2)});
  same.does(RedrawCurve{"up", CurveRole::target, same.view, same.line(-0.4, 0.2, 0.4, 0.2)});
  EXPECT_NEAR(rise(resized, "up"), rise(same, "up"), 1e-6);
  resized.view.viewport = {0, 0};
  EXPECT_EQ(resized.refuses(RedrawCurve{"up", CurveRole::target, resized.view, {{1, 1}, {2, 2}}}).place,
            "view/viewport");
}

TEST(ApplyArticulation, ASketchCanBeCancelled) {
  DocumentHand hand;
  hand.refuses(CancelDeformer{});
  const auto plain = hand.state();
  hand.does(BeginDeformer{"up", Mode::automatic, {}, 0, 1});
  EXPECT_FALSE(hand.state() == plain);
  hand.does(CancelDeformer{});
  EXPECT_EQ(hand.state(), plain);
}

TEST(ApplyArticulation, ABeginningThatLeadsNowhereIsRefused) {
  DocumentHand hand;
  const auto begin = [](const std::string& name, double minimum, double maximum) {
    return BeginDeformer{name, Mode::automatic, {}, minimum, maximum};
  };
  EXPECT_EQ(hand.refuses(begin("lift", 0, 1)).place, "name");
  EXPECT_EQ(hand.refuses(begin("base.rx", 0, 1)).place, "name");
  EXPECT_EQ(hand.refuses(begin("\xf0", 0, 1)).place, "name");
  EXPECT_EQ(hand.refuses(begin("up", 0.5, 1)).place, "range");
  EXPECT_EQ(hand.refuses(begin("up", 0, 0)).place, "range");
  EXPECT_EQ(hand.refuses(begin("up", 0, 11)).place, "range");
  EXPECT_EQ(hand.refuses(BeginDeformer{"up", Mode::automatic, articulation::Sphere{{0, 0, 0}, 0}, 0, 1}).place,
            "surface/sphere/radius");
  hand.does(BeginDeformer{"up", Mode::automatic, articulation::PartSurface{"eye"}, 0, 1});
  hand.refuses(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
}

TEST(ApplyArticulation, NamesWithoutOneAreFree) {
  DocumentHand hand;
  hand.sketch("");
  hand.sketch("");
  EXPECT_EQ(deformers(hand), (std::vector<std::string>{"deformer 1", "deformer 2"}));
  hand.does(DeleteDeformer{"deformer 1"});
  hand.sketch("");
  EXPECT_EQ(deformers(hand), (std::vector<std::string>{"deformer 2", "deformer 1"}));
}

/// Two deformers, a pose, a lock and a key that speak of both.
DocumentHand posed_hand() {
  DocumentHand hand;
  hand.sketch("up_L");
  hand.sketch("other");
  hand.does(SetParameters{{{"lift", 0.125}, {"up_L", 0.25}, {"other", 0.5}, {"base.ry", 0.75}}});
  hand.does(LockParameters{{"up_L", "base.ry", "lift"}, true});
  hand.does(SetKey{1, "smile"});
  return hand;
}

TEST(ApplyArticulation, ARenameKeepsPoseKeysAndLocks) {
  auto hand = posed_hand();
  const auto pose = hand.document().pose;
  hand.does(RenameDeformer{"up_L", "zygomatic"});
  EXPECT_EQ(hand.document().pose, pose);
  EXPECT_EQ(hand.value("zygomatic"), 0.25);
  EXPECT_EQ(hand.document().timeline->keys[0].pose, pose);
  EXPECT_EQ(hand.document().locked, (std::vector<std::string>{"base.ry", "lift", "zygomatic"}));
  EXPECT_EQ(hand.refuses(RenameDeformer{"up_L", "x"}).place, "deformer");
  hand.refuses(RenameDeformer{"zygomatic", "other"});
  hand.refuses(RenameDeformer{"zygomatic", "lift"});
  hand.refuses(RenameDeformer{"zygomatic", ""});
  EXPECT_EQ(hand.refuses(RenameDeformer{"zygomatic", "\x80"}).place, "to");
}

TEST(ApplyArticulation, DeletingADeformerForgetsItInPoseKeysAndLocks) {
  auto hand = posed_hand();
  hand.does(DeleteDeformer{"up_L"});
  EXPECT_FALSE(hand.has("up_L"));
  const rig::Pose expected{0.125, 0, 0.5, 0, 0.75, 0};
  EXPECT_EQ(hand.document().pose, expected);
  EXPECT_EQ(hand.document().timeline->keys[0].pose, expected);
  EXPECT_EQ(hand.document().timeline->keys[0].name, "smile");
  EXPECT_EQ(hand.document().locked, (std::vector<std::string>{"base.ry", "lift"}));
  EXPECT_EQ(hand.refuses(DeleteDeformer{"up_L"}).place, "deformer");
  hand.does(DeleteDeformer{"other"});
  EXPECT_EQ(hand.document().model->deformers, nullptr);
  EXPECT_EQ(hand.refuses(MirrorDeformer{"other"}).place, "deformer") << "also where there is none at all";
}

TEST(ApplyArticulation, MovingADeformerTakesItsValuesWithIt) {
  auto hand = posed_hand();
  hand.does(MoveDeformer{"other", 0});
  EXPECT_EQ(deformers(hand), (std::vector<std::string>{"other", "up_L"}));
  EXPECT_EQ(hand.document().pose, (rig::Pose{0.125, 0, 0.5, 0.25, 0, 0.75, 0}));
  EXPECT_EQ(hand.document().timeline->keys[0].pose, hand.document().pose);
  hand.refuses(MoveDeformer{"other", 2});
}

TEST(ApplyArticulation, AMirroredDeformerIsAnotherOne) {
  auto hand = posed_hand();
  hand.does(MirrorDeformer{"up_L"});
  EXPECT_EQ(deformers(hand), (std::vector<std::string>{"up_L", "other", "up_R"}));
  EXPECT_EQ(hand.value("up_R"), 0);
  EXPECT_EQ(hand.value("base.ry"), 0.75);
  EXPECT_NEAR(rise(hand, "up_R"), 0.3, 0.1) << "the sheet is its own mirror image";
  hand.refuses(MirrorDeformer{"up_L"});
  hand.refuses(MirrorDeformer{"up_L", "other"});
  hand.does(MirrorDeformer{"up_L", "another"});
  EXPECT_EQ(deformers(hand), (std::vector<std::string>{"up_L", "other", "up_R", "another"}));
}

TEST(ApplyArticulation, ADeformerFollowsItsCurvesDrawnAgain) {
  auto hand = posed_hand();
  const double before = rise(hand, "other");
  hand.does(RedrawCurve{"other", CurveRole::target, hand.view, hand.line(-0.4, 0.15, 0.4, 0.15)});
  EXPECT_LT(rise(hand, "other"), 0.7 * before);
  EXPECT_EQ(hand.value("other"), 0.5) << "its value stays";
  hand.does(RedrawCurve{"other", CurveRole::reference, hand.view, hand.line(-0.4, 0.02, 0.4, 0.02)});
  hand.does(RedrawCurve{"other", CurveRole::reference, hand.view, {}});
  EXPECT_TRUE(hand.document().model->deformers->deformers()[1]->sketch().reference.empty()) << "inferred again";
  hand.refuses(RedrawCurve{"other", CurveRole::target, hand.view, {}});
  View turned = hand.view;
  turned.camera.eye.x = 2;
  hand.refuses(RedrawCurve{"other", CurveRole::general, turned, hand.diamond(0.8)});
  EXPECT_EQ(hand.refuses(RedrawCurve{"none", CurveRole::target, hand.view, hand.line(0, 0, 1, 0)}).place, "deformer");
}

TEST(ApplyArticulation, ANarrowerRangeHoldsPoseAndKeys) {
  auto hand = posed_hand();
  hand.does(ChangeDeformer{"other", Mode::rotate, std::nullopt, std::nullopt, 0.25});
  EXPECT_EQ(hand.value("other"), 0.25);
  EXPECT_EQ(hand.document().timeline->keys[0].pose[3], 0.25);
  const articulation::Sketch& sketch = hand.document().model->deformers->deformers()[1]->sketch();
  EXPECT_EQ(sketch.mode, Mode::rotate);
  EXPECT_EQ(sketch.minimum, 0) << "what is not given stays";
  hand.does(ChangeDeformer{"other", std::nullopt, std::nullopt, -1.0, std::nullopt});
  EXPECT_EQ(hand.document().model->deformers->deformers()[1]->sketch().mode, Mode::rotate);
  hand.refuses(ChangeDeformer{"other", std::nullopt, std::nullopt, 0.5, std::nullopt});
  EXPECT_EQ(hand.refuses(ChangeDeformer{"none", Mode::rotate, {}, {}, {}}).place, "deformer");
}

TEST(ApplyArticulation, NoControlTakesTheNameOfTheSketchThatGoesOn) {
  auto hand = posed_hand();
  hand.does(BeginDeformer{"up_R", Mode::automatic, {}, 0, 1});
  hand.refuses(MirrorDeformer{"up_L"});
  hand.refuses(RenameDeformer{"other", "up_R"});
  hand.does(RenameDeformer{"other", "third"});
  hand.does(SketchCurve{CurveRole::general, hand.view, hand.diamond(0.8)});
  hand.does(SketchCurve{CurveRole::specific, hand.view, hand.diamond(0.4)});
  hand.does(SketchCurve{CurveRole::target, hand.view, hand.line(-0.4, 0.3, 0.4, 0.3)});
  EXPECT_EQ(deformers(hand), (std::vector<std::string>{"up_L", "third", "up_R"}));
}

}  // namespace
}  // namespace penpose::document
