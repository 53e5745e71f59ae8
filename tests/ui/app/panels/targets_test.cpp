#include <gtest/gtest.h>
#include <set>

#include "tests/support/app_desk.h"
#include "ui/app/menu/menu_sections.h"
#include "ui/app/widgets/internal/tokens.h"

// A pen hits everything: no target is smaller than 32 px at scale 1.

namespace penpose::app {
namespace {

class Targets : public ::testing::Test {
 protected:
  Targets() : desk("targets") {
    desk.begin();
    desk.app->of<Pointer>().resized({1440, 900}, 96);
    desk.frames();
  }
  void expect_large(const std::string& where) {
    EXPECT_FALSE(desk.interface->targets().empty()) << where;
    for (const auto& [label, area] : desk.interface->targets()) {
      // Numbers at an axis are read alone. One is told once, wherever it stands.
      if (label.starts_with("axis ") && label.size() > 6) continue;
      if (std::min(area.width(), area.height()) >= static_cast<double>(k_least_target_px) || !told.insert(label).second)
        continue;
      ADD_FAILURE() << label << ": " << area.width() << " x " << area.height() << " px, " << where;
    }
  }
  Desk desk;
  std::set<std::string> told;
};

TEST_F(Targets, OfPanelsAreLargeEnoughInEveryWindow) {
  for (const auto& [width, height] : {std::pair{800, 600}, std::pair{1280, 800}, std::pair{1440, 900}}) {
    desk.app->of<Pointer>().resized({width, height}, 96);
    desk.frames();
    const std::string where = std::to_string(width) + "x" + std::to_string(height);
    expect_large(where);
    for (const char* action : {"dope_sheet", "curve_editor", "library", "mouths", "tool_feature", "tool_ghost",
                               "tool_articulate", "tool_draw"}) {
      desk.app->of<Actions>().run(Action{action});
      desk.frames();
      expect_large(where + ", " + action);
    }
  }
}

TEST_F(Targets, OfMenusAreLargeEnough) {
  for (const MenuSection& section : menu_sections()) {
    desk.open_menu(std::string(section.name));
    expect_large("the menu, " + std::string(section.name));
    desk.hit_escape();
  }
  desk.app->of<PanelState>().radial = PxPoint{700, 400};
  desk.frames();
  expect_large("the menu around the pen");
}

TEST_F(Targets, OfDialogsAreLargeEnough) {
  for (const char* name : {"open",     "save",    "export",   "recent",   "steps",  "tablet",      "pad",
                           "sessions", "unsaved", "number",   "key name", "radial", "shortcuts",   "search",
                           "history",  "film",    "backdrop", "sound",    "clips",  "preferences", "first pass"}) {
    desk.show(Dialog{name});
    expect_large(std::string("the dialog ") + name);
    desk.app->of<Dialogs>().close();
    desk.frames();
  }
}

TEST_F(Targets, OfAFaceWithKeysAndLinesAreLargeEnough) {
  desk.set("jaw", 0.7);
  desk.app->of<Actions>().run(Action::key_pose);
  desk.app->of<Playback>().go_to(1);
  desk.set("jaw", 0);
  desk.app->of<Actions>().run(Action::key_pose);
  desk.frames();
  expect_large("two keys");
  for (const Action action : {Action::dope_sheet, Action{"overlap"}, Action::curve_editor}) {
    desk.app->of<Actions>().run(action);
    desk.frames();
    expect_large(std::string("two keys, ") + std::string(action.name));
  }
}

}  // namespace
}  // namespace penpose::app
