#include "ui/app/action.h"

#include <gtest/gtest.h>
#include <map>

namespace penpose::app {
namespace {

TEST(Action, NoTwoActionsHaveOneKey) {
  std::map<std::string, std::string_view> taken;
  for (const ActionInfo& one : all_actions()) {
    for (const KeyStroke& key : {one.key, one.other}) {
      if (key.key == 0) continue;
      const auto [at, is_new] = taken.emplace(shortcut_text(key), one.label);
      EXPECT_TRUE(is_new) << one.label << " and " << at->second << " share " << at->first;
      EXPECT_EQ(action_of(key), &one);
    }
  }
}

TEST(Action, EveryActionIsInTheListOnceAndSaysWhatItDoes) {
  for (int i = 0; i <= static_cast<int>(Action::perform); ++i) {
    const auto action = static_cast<Action>(i);
    EXPECT_EQ(info(action).action, action) << i;
    EXPECT_FALSE(info(action).tip.empty());
  }
  EXPECT_EQ(all_actions().size(), static_cast<std::size_t>(Action::backdrop_off) + 1);
}

TEST(Action, TooltipsShowTheShortcut) {
  EXPECT_EQ(tooltip_of(Action::redo), "Bring back what was undone (Ctrl+Shift+Z)");
  EXPECT_EQ(shortcut_text({' ', false, false}), "Space");
  EXPECT_EQ(action_of({'q', false, false}), nullptr);
}

}  // namespace
}  // namespace penpose::app
