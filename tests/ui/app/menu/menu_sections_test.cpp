#include "ui/app/menu/menu_sections.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

#include "tests/support/app_desk.h"
#include "ui/app/camera/camera_actions.h"

// The menu has everything, once, where one looks for it.

namespace penpose::app {
namespace {

TEST(MenuSections, EveryActionIsInOneSectionOnce) {
  std::map<std::string_view, int> times;
  for (const MenuSection& section : menu_sections()) {
    for (const auto& group : section.groups) {
      EXPECT_FALSE(group.empty()) << section.name;
      for (const Action action : group) ++times[action.name];
    }
  }
  for (const auto& [name, count] : times) EXPECT_EQ(count, 1) << name;
  std::size_t cameras = 0;
  for (const ActionInfo& one : all_actions()) {
    const bool of_dialog = is_camera_key(one.action);
    if (of_dialog) ++cameras;
    EXPECT_EQ(times.count(one.action.name), of_dialog ? 0U : 1U) << one.action.name;
  }
  EXPECT_EQ(times.size() + cameras, all_actions().size()) << "something in the menu is no action";
}

TEST(MenuSections, EachHasItsNameAnIconAndEntries) {
  std::set<std::string_view> names;
  for (const MenuSection& section : menu_sections()) {
    EXPECT_TRUE(names.insert(section.name).second) << section.name;
    EXPECT_FALSE(section.icon.empty()) << section.name;
    EXPECT_FALSE(section.groups.empty()) << section.name;
  }
  EXPECT_EQ(names, (std::set<std::string_view>{"File", "Edit", "View", "Character", "Animation", "Tablet", "Help"}));
}

TEST(MenuSections, WordsInOneSectionDiffer) {
  for (const MenuSection& section : menu_sections()) {
    std::set<std::string_view> labels;
    for (const auto& group : section.groups) {
      for (const Action action : group) EXPECT_TRUE(labels.insert(info(action).label).second) << info(action).label;
    }
  }
}

TEST(MenuSections, ATouchShowsASectionAndTheNextTouchDoesWhatItSays) {
  Desk desk("sections");
  desk.begin();
  for (const MenuSection& section : menu_sections()) {
    desk.open_menu(std::string(section.name));
    for (const auto& group : section.groups) {
      for (const Action action : group) {
        if (action == Action::theme || !desk.app->of<Actions>().usable(action)) continue;
        EXPECT_NE(desk.interface->find(info(action).label), nullptr) << info(action).label << " in " << section.name;
      }
    }
    desk.hit_escape();
  }
  desk.click("Menu");
  EXPECT_NE(desk.interface->find("Shortcuts"), nullptr) << "it opens where it was left";
  desk.click("View##section");
  desk.click("Full screen");
  EXPECT_TRUE(desk.app->of<CanvasLook>().fullscreen);
  EXPECT_EQ(desk.interface->find("View##section"), nullptr) << "what was chosen closes the menu";
}

TEST(MenuSections, InASmallWindowEverySectionIsWithinIt) {
  Desk desk("sections-small");
  desk.begin();
  desk.app->of<Pointer>().resized({800, 600}, 96);
  desk.frames();
  for (const MenuSection& section : menu_sections()) {
    desk.open_menu(std::string(section.name));
    for (const auto& group : section.groups) {
      for (const Action action : group) {
        const Area* area = desk.interface->find(info(action).label);
        if (area == nullptr || action == Action::theme) continue;
        EXPECT_LE(area->right, 800) << info(action).label;
      }
    }
    desk.hit_escape();
  }
}

}  // namespace
}  // namespace penpose::app
