#include "ui/app/interface.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

void expect_large_enough(const Desk& desk, double dpi) {
  const double least = 9 / 25.4 * dpi;
  ASSERT_GT(desk.interface->targets().size(), 10U);
  for (const auto& [label, area] : desk.interface->targets()) {
    EXPECT_GE(area.height() + 0.5, least) << label;
    EXPECT_GE(area.width() + 0.5, least) << label;
  }
}

TEST(Interface, WhatAPenHasToHitIsAtLeastNineMillimetresOnAnyDisplay) {
  Desk desk("targets");
  desk.begin();
  for (const double dpi : {96.0, 160.0, 220.0}) {
    desk.app->resized({static_cast<int>(1280 * dpi / 96), static_cast<int>(800 * dpi / 96)}, dpi);
    desk.frames();
    expect_large_enough(desk, dpi);
    for (const Dialog dialog :
         {Dialog::open, Dialog::save, Dialog::steps, Dialog::tablet, Dialog::sessions, Dialog::unsaved}) {
      desk.app->panels().dialog = dialog;
      desk.frames();
      expect_large_enough(desk, dpi);
      desk.app->panels().dialog = Dialog::none;
    }
    desk.app->panels().radial = PxPoint{600, 400};
    desk.frames();
    expect_large_enough(desk, dpi);
    desk.app->panels().radial.reset();
  }
}

TEST(Interface, EverythingThatHasAKeyIsReachedWithoutAKeyboard) {
  Desk desk("reach");
  desk.begin();
  for (const char* label :
       {"Pose", "Redraw", "Hold", "Pin",  "Erase", "Select", "Rig",    "Clear", "Rest pose",  "Menu", "Undo",
        "Redo", "Front",  "3/4",  "Side", "Frame", "Wire",   "Panels", "Key",   "Delete key", "Play", "Onion"}) {
    EXPECT_NE(desk.interface->find(label), nullptr) << label;
  }
  desk.click("Menu");
  for (const char* label :
       {"Open", "Save", "Save as", "Sessions", "Tablet", "Full screen", "Larger", "Smaller", "Help", "Quit"}) {
    EXPECT_NE(desk.interface->find(label), nullptr) << label;
  }
}

TEST(Interface, PanelsHideAndComeBackWithoutAKeyboard) {
  Desk desk("hide");
  desk.begin();
  desk.click("Panels");
  EXPECT_EQ(desk.interface->find("Pose"), nullptr);
  desk.click("Panels");
  EXPECT_NE(desk.interface->find("Pose"), nullptr);
}

TEST(Interface, TheSearchShowsWhatItFinds) {
  Desk desk("search");
  desk.begin();
  desk.click("##search");
  EXPECT_TRUE(desk.interface->wants_keys());
  desk.interface->text("JAW");
  desk.frames();
  EXPECT_EQ(desk.app->panels().filter, "JAW");
  EXPECT_NE(desk.interface->find("slider jaw"), nullptr);
  EXPECT_EQ(desk.interface->find("slider cheek_L"), nullptr);
}

}  // namespace
}  // namespace penpose::app
