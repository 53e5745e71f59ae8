#include "ui/app/settings.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <unistd.h>

namespace penpose::app {
namespace {

TEST(Settings, WhatIsWrittenIsReadAgain) {
  Settings settings;
  settings.scale = 1.5;
  settings.light = true;
  settings.steps_seen = true;
  settings.pose_first = true;
  settings.sheet_height = 123.5;
  settings.curves_height = 400;
  settings.side_closed = true;
  settings.tablet.left_handed = true;
  settings.radial[0] = Action::view_side;
  settings.radial[7] = Action::save_as;
  settings.tablet.area = {0.1, 0.2, 0.8, 0.9};
  settings.tablet.pressure = {{0, 0}, {0.5, 0.25}, {1, 1}};
  remember_file(settings, "/tmp/a b=c.glb");
  remember_file(settings, "/tmp/second.glb");
  EXPECT_EQ(parse_settings(to_text(settings)), settings);
}

TEST(Settings, BindingsOfTabletsAreKept) {
  Settings settings;
  settings.pads["056a:0314"]["BTN_1"] = binding_of(ViewHold::zoom);
  settings.pads["056a:0314"]["ring 1 light 2"] = binding_of(DialUse::keys);
  settings.pads["Huion H640P"]["pen button 2"] = binding_of(drawing::ToolKind::erase);
  EXPECT_EQ(parse_settings(to_text(settings)), settings);
  EXPECT_TRUE(parse_settings("pad=a|b\npad=a|b|fly\npad=\npad=||\npad=a\n").pads.empty());
}

TEST(Settings, WhateverIsInTheFileItIsReadAndWrittenTheSame) {
  Settings full;
  full.pads["056a:0314"]["BTN_1"] = binding_of(Action::frame_all);
  full.pads["056a:0314"]["ring 1 light 1"] = binding_of(DialUse::time);
  full.keys.set(Action::undo, 0, {'u', false, false});
  full.keys.set(Action::redo, 1, {'z', true, false});
  remember_file(full, "/tmp/a.glb");
  const std::string whole = to_text(full);
  std::mt19937 random(5);
  for (int i = 0; i < 20000; ++i) {
    std::string text = whole;
    for (unsigned n = random() % 4 + 1; n > 0; --n) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(at, random() % 8);
      } else {
        text[at] = "|=\n ab1\xff"[random() % 8];
      }
      if (text.empty()) text.push_back('\n');
    }
    const Settings read = parse_settings(text);
    ASSERT_EQ(parse_settings(to_text(read)), read) << text;
  }
}

TEST(Settings, WhatCannotBeReadKeepsItsDefault) {
  const Settings settings = parse_settings(
      "scale=99\nlight=maybe\ntablet_area=0.9 0 0.1 1\ntablet_pressure=1 2 3\n=\nscale\n\x01\xff=\nsteps_seen=1");
  Settings expected;
  expected.steps_seen = true;
  expected.unread = {"scale=99", "light=maybe", "tablet_area=0.9 0 0.1 1", "tablet_pressure=1 2 3", "=",
                     "scale",    "\x01\xff="};
  EXPECT_EQ(settings, expected);
}

TEST(Settings, ALineThatIsNotTakenIsNamedAndStaysInTheFile) {
  std::vector<base::Error> refused;
  Settings settings = parse_settings(
      "# mine\nlight=1\nkey=fly|Q\nkey=undo|Hyper+Q\nkey=undo|U\nkey=redo|U\nnew_thing=3\nkey=cancel|Q\n", &refused);
  ASSERT_EQ(refused.size(), 5U) << "a remark is no mistake";
  EXPECT_EQ(refused[0].line("settings"),
            "settings: line 3: \"key=fly|Q\" is not taken: no action is called that; mend the line or take it out");
  EXPECT_NE(refused[1].what.find("a key is written as"), std::string::npos);
  EXPECT_NE(refused[2].what.find("another line gives that key to undo"), std::string::npos);
  EXPECT_NE(refused[3].what.find("sets nothing that is known"), std::string::npos);
  EXPECT_NE(refused[4].what.find("stay what they are"), std::string::npos);
  EXPECT_EQ(settings.keys.shortcut_of(Action::undo), "U");
  settings.light = false;
  const std::string text = to_text(settings);
  for (const char* kept : {"# mine\n", "key=fly|Q\n", "key=undo|Hyper+Q\n", "new_thing=3\n", "light=0\n"})
    EXPECT_NE(text.find(kept), std::string::npos) << kept;
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
