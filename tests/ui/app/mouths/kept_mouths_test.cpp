#include "ui/app/mouths/kept_mouths.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/mouths/mouth_slots.h"

namespace penpose::app {
namespace {

double value_in(const document::Mouth& mouth, const std::string& control) {
  for (const auto& one : mouth.values) {
    if (one.name == control) return one.value;
  }
  return 0;
}

class KeptMouthsOfDesk : public ::testing::Test {
 protected:
  explicit KeptMouthsOfDesk() : desk_("mouths") {
    desk_.begin();
    desk_.press('l', true, true);
  }
  void set(const std::string& control, double value) {
    desk_.app->of<EditingSession>().perform(document::SetParameters{{{control, value}}});
    desk_.frames();
  }
  [[nodiscard]] const document::Mouth* kept(const std::string& name) const {
    return document::find_mouth(desk_.document().mouths, name);
  }
  [[nodiscard]] double pose(const std::string& control) const {
    const auto parameters = desk_.document().model->rig->parameters();
    return desk_.document().pose[rig::find_parameter(parameters, control).value()];
  }
  EditingSession& editing() { return desk_.app->of<EditingSession>(); }

  Desk desk_;
};

TEST_F(KeptMouthsOfDesk, AnEmptyPlaceKeepsThePresentMouthAloneByOneTap) {
  set("jaw", 0.6);
  set("left brow", 0.5);
  desk_.click("mouth A");
  ASSERT_NE(kept("A"), nullptr);
  EXPECT_EQ(value_in(*kept("A"), "jaw"), 0.6);
  for (const auto& one : kept("A")->values) EXPECT_EQ(one.name.find("brow"), std::string::npos) << one.name;
  desk_.app->of<Playback>().undo();
  EXPECT_EQ(kept("A"), nullptr);
  EXPECT_EQ(pose("jaw"), 0.6);
}

TEST_F(KeptMouthsOfDesk, AKeptMouthIsNotLostByATap) {
  set("jaw", 0.6);
  desk_.click("mouth A");
  set("jaw", 0.1);
  desk_.click("mouth A");
  EXPECT_EQ(value_in(*kept("A"), "jaw"), 0.6);
  EXPECT_EQ(pose("jaw"), 0.1) << "it is chosen, and nothing else";
  desk_.click("Replace##mouth");
  EXPECT_EQ(value_in(*kept("A"), "jaw"), 0.1);
}

TEST_F(KeptMouthsOfDesk, RedrawnItIsShownAndKeptAgainByATapAndItsKeysFollow) {
  set("jaw", 0.6);
  desk_.click("mouth A");
  set("jaw", 0);
  desk_.click("mouth rest");
  editing().perform(document::KeyMouths{{0.5, 1, 1.5}, {"rest", "A", "rest"}});
  editing().perform(document::GoToTime{0});
  desk_.frames();
  desk_.click("mouth A");
  desk_.click("Redraw##mouth");
  EXPECT_EQ(pose("jaw"), 0.6);
  set("jaw", 0.8);
  desk_.click("mouth A");
  EXPECT_EQ(value_in(*kept("A"), "jaw"), 0.8);
  const auto jaw = rig::find_parameter(desk_.document().model->rig->parameters(), "jaw").value();
  EXPECT_EQ(document::pose_at(desk_.document(), 1)[jaw], 0.8);
  EXPECT_EQ(pose("jaw"), 0) << "the moment goes on as it was spoken";
  desk_.app->of<Playback>().undo();
  EXPECT_EQ(value_in(*kept("A"), "jaw"), 0.6);
  EXPECT_EQ(document::pose_at(desk_.document(), 1)[jaw], 0.6);
}

TEST_F(KeptMouthsOfDesk, TheModelsOwnControlsFillThePlacesThatAreEmptyInOneStep) {
  set("jaw", 0.3);
  desk_.click("mouth A");
  desk_.click("From the model's own controls##mouth");
  EXPECT_EQ(desk_.document().mouths.size(), 9U);
  EXPECT_EQ(value_in(*kept("A"), "jaw"), 0.3) << "the artist's own stays";
  EXPECT_EQ(desk_.interface->find("From the model's own controls##mouth"), nullptr);
  desk_.app->of<Playback>().undo();
  EXPECT_EQ(desk_.document().mouths.size(), 1U);
}

TEST_F(KeptMouthsOfDesk, AMouthIsDeletedAndItsPlaceIsFree) {
  set("jaw", 0.6);
  desk_.click("mouth A");
  desk_.click("mouth A");
  desk_.click("Delete##mouth");
  EXPECT_EQ(kept("A"), nullptr);
  desk_.click("mouth A");
  EXPECT_NE(kept("A"), nullptr);
}

TEST_F(KeptMouthsOfDesk, AllNinePlacesAreSeenInASmallWindow) {
  desk_.app->of<Pointer>().resized({800, 600}, 96);
  desk_.frames();
  desk_.press('l', true, true);
  desk_.press('l', true, true);
  for (const MouthSlot& slot : k_mouth_slots)
    EXPECT_NE(desk_.interface->find("mouth " + std::string(slot.name())), nullptr) << slot.name();
}

TEST(MouthSlots, ComeInTheOrderInWhichTheyAreNeeded) {
  document::Mouths mouths;
  std::string order;
  while (const MouthSlot* next = next_slot(mouths)) {
    order.append(next->name()).append(" ");
    mouths.push_back(std::make_shared<const document::Mouth>(document::Mouth{std::string(next->name()), {}}));
  }
  EXPECT_EQ(order, "closed A E O F L consonants U rest ");
}

}  // namespace
}  // namespace penpose::app
