#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/dialogs/found_command.h"

// The search over everything, and the list of keys.

namespace penpose::app {
namespace {

using Kind = FoundCommand::Kind;

std::vector<FoundCommand> found_at(Desk& desk, const char* text) {
  const Settings& settings = desk.app->of<Preferences>().settings();
  const SearchedIn in{desk.document(), settings.keys, desk.app->of<Playback>().rate(), settings.recent};
  return find_commands(in, text);
}

TEST(Finding, ActionsControlsPosesAndFilesAreFound) {
  Desk desk("find");
  desk.begin();
  desk.click("Key");
  desk.app->of<Keys>().name("big smile");
  ASSERT_TRUE(desk.app->of<Files>().save(desk.path("grin.glb")).ok());
  const auto first = [&](const char* text) {
    const auto found = found_at(desk, text);
    return found.empty() ? FoundCommand{} : found.front();
  };
  EXPECT_EQ(first("undo").action, Action::undo);
  EXPECT_EQ(first("undo").detail, "Ctrl+Z");
  EXPECT_EQ(first("brow_inner_l").kind, Kind::control);
  EXPECT_EQ(first("smile big").kind, Kind::pose) << "words in any order";
  EXPECT_EQ(first("grin").kind, Kind::file);
  EXPECT_EQ(first("x-mirror").action, Action::mirror_strokes);
  EXPECT_TRUE(found_at(desk, "no such thing").empty());
}

TEST(Finding, WhatIsTypedAndChosenIsDone) {
  Desk desk("search-dialog");
  desk.begin();
  desk.app->of<PanelState>().has_keyboard = true;
  desk.hit(14, 'k', true);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::search);
  desk.type("wire");
  desk.hit_return();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_TRUE(desk.app->of<CanvasLook>().wireframe);
  // The arrows choose another one.
  desk.hit(14, 'k', true);
  desk.type("undo");
  ASSERT_GT(found_at(desk, "undo").size(), 1U);
  const auto second = found_at(desk, "undo")[1];
  desk.hit(81, k_key_down);
  EXPECT_EQ(desk.app->of<Dialogs>().state<SearchEntry>().chosen, 1U);
  desk.hit_escape();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  // A control that is found is shown.
  desk.hit(14, 'k', true);
  desk.type("jaw");
  desk.hit_return();
  EXPECT_EQ(desk.app->of<PanelState>().own.of<ParameterList>().filter, "jaw");
  EXPECT_NE(desk.interface->find("slider jaw"), nullptr);
}

TEST(Finding, EveryKeyIsInTheList) {
  Desk desk("shortcuts");
  desk.begin();
  desk.press('/', false, true);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::shortcuts);
  desk.hit_escape();
  desk.press(k_key_f1);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::shortcuts);
  desk.type("frame");
  EXPECT_NE(desk.interface->find("Frame on##shortcut"), nullptr);
  EXPECT_EQ(desk.interface->find("Undo##shortcut"), nullptr) << "what does not fit is not listed";
  desk.click("Frame on##shortcut");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 1.0 / 24) << "a touch does it";
}

TEST(Finding, TheListOfKeysHasAllOfThem) {
  Desk desk("all-keys");
  desk.begin();
  desk.press(k_key_f1);
  for (const ActionInfo& one : all_actions()) {
    if (one.key.key == 0 || one.action == Action::search) continue;
    desk.app->of<Dialogs>().state<SearchEntry>().text = one.label;
    desk.frames(3);
    EXPECT_NE(desk.interface->find(std::string(one.label) + "##shortcut"), nullptr) << one.label;
  }
}

}  // namespace
}  // namespace penpose::app
