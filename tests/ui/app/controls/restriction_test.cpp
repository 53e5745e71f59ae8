#include "ui/app/controls/restriction.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/controls/meant_controls.h"

// Which controls lines may move: only some, with one touch and back with another.

namespace penpose::app {
namespace {

using Names = std::vector<std::string>;

Names mouth_of(Desk& desk) {
  return controls_of_part(desk.app->of<EditingSession>(), desk.app->of<PanelState>().own.of<ControlParts>(),
                          FacePart::mouth)
      .names;
}

bool locked(const Desk& desk, const std::string& name) {
  return std::binary_search(desk.document().locked.begin(), desk.document().locked.end(), name);
}

TEST(Restriction, OnlyTheBrowsMoveAndAChipSaysSoWhichFreesAll) {
  Desk desk("only");
  desk.begin();
  desk.app->of<Actions>().run(Action{"only_brows"});
  desk.frames();
  EXPECT_EQ(desk.app->of<Restriction>().words(), "Only the brows");
  ASSERT_NE(desk.interface->find("restriction"), nullptr);
  desk.press('b');
  pose_mouth(desk);
  EXPECT_EQ(desk.document().pose, rig::rest_pose(*desk.document().model->rig)) << "a line of the mouth moves nothing";
  desk.stroke(desk.named_curve("brow_L"));
  desk.stroke(desk.named_curve("brow_L", {0, -12}));
  EXPECT_NE(desk.document().pose, rig::rest_pose(*desk.document().model->rig)) << "a brow moves";
  desk.click("restriction");
  EXPECT_TRUE(desk.document().locked.empty());
  EXPECT_EQ(desk.interface->find("restriction"), nullptr);
}

TEST(Restriction, WhatWasLockedByHandStaysLockedWhenItIsLifted) {
  Desk desk("own-locks");
  desk.begin();
  auto& restriction = desk.app->of<Restriction>();
  desk.app->of<EditingSession>().perform(document::LockParameters{{"jaw", "brow_inner_L"}, true});
  restriction.only(mouth_of(desk), "the mouth");
  EXPECT_TRUE(locked(desk, "jaw")) << "it may not move, mouth or not";
  EXPECT_FALSE(locked(desk, "mouth_corner_L"));
  restriction.lift();
  EXPECT_EQ(desk.document().locked, (Names{"brow_inner_L", "jaw"}));
}

TEST(Restriction, AnotherTakesItsPlaceInOneStepAndUndoGoesBackToTheFirst) {
  Desk desk("replaced");
  desk.begin();
  auto& restriction = desk.app->of<Restriction>();
  desk.app->of<Actions>().run(Action{"only_brows"});
  desk.app->of<Actions>().run(Action{"only_mouth"});
  EXPECT_EQ(restriction.words(), "Only the mouth");
  EXPECT_FALSE(locked(desk, "jaw"));
  EXPECT_TRUE(locked(desk, "brow_inner_L"));
  desk.press('z', true);
  EXPECT_EQ(restriction.words(), "Only the brows");
  EXPECT_TRUE(locked(desk, "jaw"));
  EXPECT_FALSE(locked(desk, "brow_inner_L"));
  desk.press('z', true);
  EXPECT_EQ(restriction.words(), "");
  EXPECT_TRUE(desk.document().locked.empty());
  desk.press('z', true, true);
  EXPECT_EQ(restriction.words(), "Only the brows") << "and forth";
}

TEST(Restriction, AllButSomeMayMove) {
  Desk desk("without");
  desk.begin();
  auto& restriction = desk.app->of<Restriction>();
  restriction.without({"jaw"}, "jaw opens");
  EXPECT_EQ(restriction.words(), "Not jaw opens");
  EXPECT_EQ(desk.document().locked, Names{"jaw"});
  EXPECT_FALSE(restriction.is_only({"jaw"}));
  restriction.only({"jaw"}, "jaw opens");
  EXPECT_TRUE(restriction.is_only({"jaw"}));
  EXPECT_FALSE(locked(desk, "jaw"));
  restriction.only({"no such control"}, "nothing");
  EXPECT_TRUE(restriction.is_only({"jaw"})) << "what is not there changes nothing";
}

TEST(Restriction, TheseAreWhatTheLastLineMoved) {
  Desk desk("these");
  desk.begin();
  desk.press('b');
  const std::string moved = moved_with_mouth(desk);
  desk.app->of<Actions>().run(Action{"only_these"});
  desk.frames();
  EXPECT_FALSE(locked(desk, moved));
  EXPECT_TRUE(locked(desk, "brow_inner_L"));
  EXPECT_TRUE(desk.app->of<Restriction>().words().starts_with("Only "));
}

TEST(Restriction, UnlockingOneByHandLetsItMoveAndTheRestStaysRestricted) {
  Desk desk("one-more");
  desk.begin();
  auto& restriction = desk.app->of<Restriction>();
  desk.app->of<Actions>().run(Action{"only_brows"});
  desk.app->of<EditingSession>().perform(document::LockParameters{{"jaw"}, false});
  EXPECT_EQ(restriction.words(), "Only the brows");
  restriction.lift();
  EXPECT_TRUE(desk.document().locked.empty());
}

TEST(Restriction, TheMenuOfAFeatureOffersItsPart) {
  Desk desk("feature-menu");
  desk.begin();
  desk.press('v');
  desk.frames();
  desk.click("feature lip_upper");
  ASSERT_NE(desk.interface->find("Only the mouth##part"), nullptr);
  desk.click("Only the mouth##part");
  EXPECT_EQ(desk.app->of<Restriction>().words(), "Only the mouth");
  EXPECT_FALSE(desk.app->of<PanelState>().feature_menu.has_value());
}

TEST(Restriction, AStringGoesOnWithWhatMayMove) {
  Desk desk("string");
  desk.begin();
  desk.app->of<Restriction>().only({"jaw"}, "jaw opens");
  desk.press(' ', false, true);
  const auto lip = desk.named_curve("lip_lower");
  const PxPoint at = lip[lip.size() / 2];
  desk.app->of<Pointer>().moved(at);
  desk.app->of<Pointer>().button(MouseButton::left, true, at);
  for (int i = 1; i <= 30; ++i) {
    desk.app->of<Pointer>().moved(at + PxPoint{0, i * 0.5});
    desk.frames(1);
  }
  desk.let_go(at + PxPoint{0, 15});
  const auto parameters = desk.document().model->rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name != "jaw") {
      EXPECT_EQ(desk.document().pose[i], parameters[i].rest) << parameters[i].name;
    }
  }
  EXPECT_GT(desk.value_of("jaw"), 0.05);
}

}  // namespace
}  // namespace penpose::app
