#include "ui/app/settings.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace penpose::app {
namespace {

TEST(Settings, WhatIsWrittenIsReadAgain) {
  Settings settings;
  settings.scale = 1.5;
  settings.light = true;
  settings.steps_seen = true;
  settings.tablet.left_handed = true;
  settings.radial[0] = Action::view_side;
  settings.radial[7] = Action::save_as;
  settings.tablet.area = {0.1, 0.2, 0.8, 0.9};
  settings.tablet.pressure = {{0, 0}, {0.5, 0.25}, {1, 1}};
  remember_file(settings, "/tmp/a b=c.glb");
  remember_file(settings, "/tmp/second.glb");
  EXPECT_EQ(parse_settings(to_text(settings)), settings);
}

TEST(Settings, WhatCannotBeReadKeepsItsDefault) {
  const Settings settings = parse_settings(
      "scale=99\nlight=maybe\ntablet_area=0.9 0 0.1 1\ntablet_pressure=1 2 3\n=\nscale\n\x01\xff=\nsteps_seen=1");
  Settings expected;
  expected.steps_seen = true;
  EXPECT_EQ(settings, expected);
}

TEST(Settings, AFileThatIsOpenedAgainMovesToTheFrontAndTheListStaysShort) {
  Settings settings;
  for (int i = 0; i < 20; ++i) remember_file(settings, std::to_string(i));
  remember_file(settings, "15");
  EXPECT_EQ(settings.recent.size(), k_most_recent);
  EXPECT_EQ(settings.recent.front(), "15");
  EXPECT_EQ(settings.recent[1], "19");
}

TEST(Settings, AFolderThatIsMissingIsMade) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("penpose-settings-test-" + std::to_string(::getpid())) / "deep";
  std::filesystem::remove_all(folder.parent_path());
  Settings settings;
  settings.light = true;
  ASSERT_TRUE(save_settings(settings, folder.string()).ok());
  EXPECT_EQ(load_settings(folder.string()), settings);
  std::filesystem::remove_all(folder.parent_path());
}

}  // namespace
}  // namespace penpose::app
