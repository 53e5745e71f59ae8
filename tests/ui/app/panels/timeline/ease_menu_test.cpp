#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/playback/keys.h"

// How the face goes to the next key, as pictures.

namespace penpose::app {
namespace {

TEST(EaseMenu, TheButtonSaysTheKindOfTheKeyHereOrBeforeAndWhereThoseSelectedDiffer) {
  Desk desk("ease");
  desk.begin();
  for (const double time_s : {0.0, 1.0, 2.0})
    ASSERT_TRUE(desk.app->of<EditingSession>().perform(document::SetKey{time_s, {}}));
  desk.app->of<Playback>().go_to(0.5);
  desk.frames();
  desk.click("Smooth##kind");
  desk.click("Stepped##choose kind");
  EXPECT_NE(desk.interface->find("Stepped##kind"), nullptr) << "of the key before";
  desk.app->of<Playback>().go_to(1);
  desk.frames();
  EXPECT_NE(desk.interface->find("Smooth##kind"), nullptr);
  auto& keys = desk.app->of<Keys>();
  keys.selected().add(0, 0);
  keys.selected().add(1, 0);
  desk.frames();
  EXPECT_NE(desk.interface->find("Mixed##kind"), nullptr);
  EXPECT_EQ(keys.kinds().size(), 2U);
  desk.click("Mixed##kind");
  desk.click("Linear##choose kind");
  EXPECT_NE(desk.interface->find("Linear##kind"), nullptr);
}

}  // namespace
}  // namespace penpose::app
