#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// What is chosen once and kept, in one dialog.

namespace penpose::app {
namespace {

Settings kept(const Desk& desk) { return load_settings(desk.path("config")); }

TEST(PreferencesDialog, EveryTabChangesWhatIsKept) {
  Desk desk("preferences");
  desk.begin();
  desk.press(',', true);
  ASSERT_EQ(desk.app->of<Dialogs>().open().name, "preferences");
  desk.click("Light##colours");
  desk.click("Touch##density");
  desk.click("Larger##size");
  EXPECT_TRUE(kept(desk).light);
  EXPECT_EQ(kept(desk).density, Density::touch);
  EXPECT_DOUBLE_EQ(kept(desk).scale, 1.25);
  desk.click("Smaller##size");
  desk.click("Usual##density");
  desk.click("Pen##tab");
  desk.click("Strong##steady");
  EXPECT_EQ(kept(desk).stabiliser, Stabiliser::strong);
  desk.click("Time##tab");
  desk.click("30##rate");
  EXPECT_EQ(kept(desk).rate, 30);
  EXPECT_EQ(desk.app->of<Playback>().rate(), 30) << "nothing is keyed yet";
  desk.click("Folders##tab");
  ASSERT_TRUE(desk.app->of<Files>().save(desk.path("mine.glb")).ok());
  desk.frames();
  desk.click("Forget the list of recent files (1)##recent");
  EXPECT_TRUE(kept(desk).recent.empty());
  EXPECT_TRUE(std::filesystem::exists(desk.path("mine.glb")));
  desk.click("Keys##tab");
  desk.click("Menu around the pen##preferences");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::radial);
  desk.click("Done");
  desk.open_menu("Edit");
  desk.click("Preferences");
  EXPECT_NE(desk.interface->find("Menu around the pen##preferences"), nullptr) << "the tab of before";
  desk.hit_escape();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
}

TEST(PreferencesDialog, AnotherUsualRateLeavesWhatIsKeyedOnItsFrames) {
  Desk desk("preferences-rate");
  desk.begin();
  desk.click("Key");
  desk.press(',', true);
  desk.click("Time##tab");
  desk.click("60##rate");
  EXPECT_EQ(kept(desk).rate, 60);
  EXPECT_EQ(desk.app->of<Playback>().rate(), 24);
}

TEST(PreferencesDialog, ItFitsSmallScreens) {
  Desk desk("preferences-small");
  desk.begin();
  for (const auto& [width, height] : {std::pair{800, 600}, std::pair{640, 480}}) {
    desk.app->of<Pointer>().resized({width, height}, 96);
    desk.app->of<Dialogs>().show(Dialog{"preferences"});
    desk.frames();
    desk.expect_within(width, height, {"View##tab", "Folders##tab", "Done"});
  }
}

}  // namespace
}  // namespace penpose::app
