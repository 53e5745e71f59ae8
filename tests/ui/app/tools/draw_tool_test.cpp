#include <cmath>
#include <gtest/gtest.h>

#include "core/rig/rig.h"
#include "tests/support/app_desk.h"
#include "ui/app/face/feature_words.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/session/reading_offer.h"
#include "ui/app/view/outcome.h"

// The tool Draw: a face drawn over the built-in head, with names beside its lines.

namespace penpose::app {
namespace {

double value(const Desk& desk, const char* name) {
  return desk.document().pose[rig::find_parameter(desk.document().model->rig->parameters(), name).value()];
}

/// A brow of the view drawn higher.
void raise_brow(Desk& desk) {
  desk.begin();
  desk.click("Draw");
  desk.stroke(desk.named_curve("brow_L", {0, -14}));
}

TEST(DrawTool, IsInANewcomersHandAndTheOneTakenLastIsFoundAgain) {
  {
    Desk desk("draw-first");
    desk.begin();
    EXPECT_EQ(desk.app->of<EditingSession>().editor().tool().kind, drawing::ToolKind::pose) << "as it was chosen";
    desk.click("Draw");
  }
  {
    Desk desk("draw-first", "builtin:demo", false);
    desk.begin();
    EXPECT_EQ(desk.app->of<EditingSession>().editor().tool().kind, drawing::ToolKind::draw);
  }
  EXPECT_FALSE(Settings{}.pose_first);
}

TEST(DrawTool, ALineMovesItsFeatureAndIsNamedBesideIt) {
  Desk desk("draw-line");
  raise_brow(desk);
  ASSERT_NE(desk.document().face, nullptr);
  EXPECT_EQ(desk.document().face->lines.front().feature, "brow_L");
  EXPECT_GT(value(desk, "brow_inner_L") + value(desk, "brow_outer_L"), 0.3);
  EXPECT_NE(desk.interface->find("line 1"), nullptr);
  desk.app->of<EditingSession>().steps().undo();
  desk.frames();
  EXPECT_EQ(desk.document().face, nullptr);
  EXPECT_EQ(desk.interface->find("line 1"), nullptr);
}

TEST(DrawTool, WhereNothingMayMoveItIsSaid) {
  Desk desk("draw-restricted");
  desk.begin();
  desk.app->of<Actions>().run(Action{"only_mouth"});
  desk.frames();
  desk.click("Draw");
  desk.stroke(desk.named_curve("brow_L", {0, -14}));
  EXPECT_TRUE(outcome_of(desk.app->of<EditingSession>()).starts_with("Nothing moved: no control that may move"))
      << outcome_of(desk.app->of<EditingSession>());
}

TEST(DrawTool, TheFaceFollowsWhileALineIsDrawn) {
  Desk desk("draw-live");
  desk.begin();
  desk.click("Draw");
  const rig::Pose before = desk.document().pose;
  desk.stroke(desk.named_curve("brow_L", {0, -14}), false);
  desk.frames();
  EXPECT_EQ(desk.document().pose, before) << "nothing is done yet";
  const ShownPose& shown = desk.app->of<EditingSession>().shown();
  ASSERT_TRUE(shown.face().active());
  EXPECT_EQ(shown.face().feature(), "brow_L");
  EXPECT_NE(shown.pose(), before);
}

TEST(DrawTool, ATouchOfItsNameChangesWhatALineIs) {
  Desk desk("draw-name");
  raise_brow(desk);
  ASSERT_TRUE(desk.click("line 1"));
  ASSERT_TRUE(desk.click("Nothing of these##face"));
  EXPECT_EQ(desk.document().face->lines.front().feature, "");
  EXPECT_NEAR(value(desk, "brow_inner_L"), 0, 1e-9);
  ASSERT_TRUE(desk.click("line 1"));
  ASSERT_TRUE(desk.click("left brow##face"));
  EXPECT_EQ(desk.document().face->lines.front().feature, "brow_L");
  ASSERT_TRUE(desk.click("line 1"));
  ASSERT_TRUE(desk.click("Delete##face"));
  EXPECT_EQ(desk.document().face, nullptr);
}

/// A line between the lips, a little lower in the middle.
void draw_mouth(Desk& desk) {
  desk.begin();
  desk.click("Draw");
  auto line = desk.named_curve("lip_upper_inner");
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double t = 2.0 * static_cast<double>(i) / static_cast<double>(line.size() - 1) - 1.0;
    line[i].y += 10.0 * (1.0 - t * t);
  }
  desk.stroke(line);
  desk.frames(30);
}

TEST(DrawTool, OtherFeaturesOfALineAreOfferedAsFacesAndTakenAtATouch) {
  Desk desk("draw-meant");
  draw_mouth(desk);
  const ReadingOffer& offer = desk.app->of<ReadingOffer>();
  ASSERT_TRUE(offer.open());
  ASSERT_NE(desk.interface->find("reading 1"), nullptr);
  EXPECT_LE(offer.readings().size(), FaceReadings::k_most);
  const document::FaceLine before = desk.document().face->lines.front();
  const OfferedReading first = offer.readings().front();
  EXPECT_NE(static_cast<const rig::Pose&>(first.pose), desk.document().pose);
  EXPECT_EQ(first.words.find("lip"), std::string::npos) << "words say what moves: " << first.words;
  const rig::Pose pose = desk.document().pose;
  const Area picture = *desk.interface->find("reading 1");
  EXPECT_GT(picture.height(), picture.width()) << "a square picture with its name below";
  desk.app->of<Pointer>().moved(picture.middle());
  desk.frames();
  EXPECT_EQ(desk.app->of<EditingSession>().shown().pose(), static_cast<const rig::Pose&>(first.pose));
  EXPECT_EQ(desk.document().pose, pose) << "it is only shown";
  desk.click("reading 1");
  EXPECT_EQ(desk.document().pose, static_cast<const rig::Pose&>(first.pose));
  EXPECT_EQ(desk.document().face->lines.front().feature, first.feature);
  desk.press('z', true);
  EXPECT_EQ(desk.document().pose, pose);
  desk.frames(10);
  EXPECT_FALSE(offer.open()) << "what is undone asks no question";
}

TEST(DrawTool, ASmileDrawnBelowTheLipsIsOfferedAsASmile) {
  Desk desk("draw-smile-below");
  desk.begin();
  desk.click("Draw");
  auto line = desk.named_curve("lip_upper_inner");
  const double width = std::abs(line.back().x - line.front().x);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double t = 2.0 * static_cast<double>(i) / static_cast<double>(line.size() - 1) - 1.0;
    line[i].y += 0.25 * width * (1.0 - t * t) + 0.1 * width;
  }
  desk.stroke(line);
  desk.frames(30);
  const auto parameters = desk.document().model->rig->parameters();
  const std::size_t left = rig::find_parameter(parameters, "mouth_corner_L").value();
  const std::size_t right = rig::find_parameter(parameters, "mouth_corner_R").value();
  const std::size_t jaw = rig::find_parameter(parameters, "jaw").value();
  const auto& readings = desk.app->of<ReadingOffer>().readings();
  const auto smiles = [&](const OfferedReading& one) {
    return one.pose[left] > 0.3 && one.pose[right] > 0.3 && one.pose[jaw] < 0.2;
  };
  std::string offered;
  for (const OfferedReading& one : readings) offered += one.words + "; ";
  EXPECT_TRUE(std::any_of(readings.begin(), readings.end(), smiles)) << offered;
}

TEST(DrawTool, TheMenuOfAnOlderLineOffersItsOwnFaces) {
  Desk desk("draw-meant-older");
  draw_mouth(desk);
  desk.stroke(desk.named_curve("brow_L", {0, -14}));
  desk.frames(30);
  ASSERT_TRUE(desk.click("line 1"));
  desk.frames(30);
  const ReadingOffer& offer = desk.app->of<ReadingOffer>();
  ASSERT_TRUE(offer.open());
  EXPECT_EQ(offer.face_line(), desk.document().face->lines[0].id);
  const std::string feature = offer.readings().front().feature;
  ASSERT_TRUE(desk.click("reading 1"));
  EXPECT_EQ(desk.document().face->lines[0].feature, feature);
  EXPECT_EQ(desk.document().face->lines[1].feature, "brow_L");
  EXPECT_FALSE(desk.app->of<PanelState>().curve_menu) << "the menu closes";
}

TEST(DrawTool, ALineMayBeginOnTheNameOfAnother) {
  Desk desk("draw-over-name");
  raise_brow(desk);
  const Area* name = desk.interface->find("line 1");
  ASSERT_NE(name, nullptr);
  const PxPoint from = name->middle();
  auto line = desk.named_curve("brow_R", {0, -14});
  const PxPoint by = from - line.front();
  for (PxPoint& p : line) p = p + by;
  desk.stroke(line);
  ASSERT_NE(desk.document().face, nullptr);
  EXPECT_EQ(desk.document().face->lines.size(), 2U);
}

TEST(DrawTool, ErasesAndClearsLinesOfTheFace) {
  Desk desk("draw-erase");
  raise_brow(desk);
  desk.click("Erase");
  desk.stroke(desk.named_curve("lip_upper"));
  EXPECT_NE(desk.document().face, nullptr) << "nothing lies there";
  desk.stroke(desk.named_curve("brow_L"));
  EXPECT_EQ(desk.document().face, nullptr);
  raise_brow(desk);
  desk.click("Clear");
  EXPECT_EQ(desk.document().face, nullptr);
}

TEST(DrawTool, WhatIsDrawnAtRestIsTheNeutralFace) {
  Desk desk("draw-neutral");
  raise_brow(desk);
  desk.app->of<Actions>().run(Action::neutral);
  EXPECT_NE(desk.document().neutral, nullptr);
  EXPECT_EQ(desk.document().face, nullptr);
  EXPECT_NEAR(value(desk, "brow_inner_L"), 0, 1e-9);
  desk.app->of<Actions>().run(Action::neutral);
  EXPECT_EQ(desk.document().neutral, nullptr) << "again, without lines, it is forgotten";
}

TEST(DrawTool, FeaturesAreCalledAsOneSpeaksOfThem) {
  EXPECT_EQ(feature_words("eyelid_upper_L"), "left upper eyelid");
  EXPECT_EQ(feature_words("lip_upper_inner"), "inner upper lip");
  EXPECT_EQ(feature_words("nose_bridge"), "nose bridge");
  EXPECT_EQ(feature_words("jaw"), "jaw");
}

}  // namespace
}  // namespace penpose::app
