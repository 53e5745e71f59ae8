#include <gtest/gtest.h>
#include <map>

#include "ui/app/key_map.h"

namespace penpose::app {
namespace {

TEST(Action, NoTwoActionsHaveOneKey) {
  std::map<std::string, std::string_view> taken;
  for (const ActionInfo& one : all_actions()) {
    for (const KeyStroke& key : {one.key, one.other}) {
      if (key.key == 0) continue;
      const auto [at, is_new] = taken.emplace(shortcut_text(key), one.label);
      EXPECT_TRUE(is_new) << one.label << " and " << at->second << " share " << at->first;
      EXPECT_EQ(KeyMap().action_of(key), &one);
    }
  }
}

TEST(Action, EveryActionIsInTheListOnceAndSaysWhatItDoes) {
  for (const ActionInfo& one : all_actions()) {
    EXPECT_EQ(&info(one.action), &one) << "two are called " << one.action.name;
    EXPECT_FALSE(one.label.empty() || one.tip.empty() || one.icon.empty()) << one.action.name;
    EXPECT_TRUE(one.run != nullptr || one.tool != nullptr) << one.action.name;
  }
}

TEST(Action, EveryNamedActionIsInTheList) {
  for (const Action action : k_named_actions) EXPECT_EQ(info(action).action, action) << action.name;
}

TEST(Action, TooltipsShowTheShortcut) {
  EXPECT_EQ(KeyMap().tooltip_of(Action::redo), "Bring back what was undone (Ctrl+Shift+Z)");
  EXPECT_EQ(shortcut_text({' ', false, false}), "Space");
  EXPECT_EQ(KeyMap().action_of({'q', false, false}), nullptr);
}

}  // namespace
}  // namespace penpose::app
