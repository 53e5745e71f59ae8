#include "ui/app/key_map.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

constexpr KeyStroke k_q{'q', false, false};
constexpr KeyStroke k_ctrl_z{'z', true, false};

TEST(KeyStroke, WhatIsShownIsReadAgain) {
  for (const KeyStroke& key :
       {k_q, k_ctrl_z, KeyStroke{'+', true, false}, KeyStroke{' ', false, true}, KeyStroke{k_key_f1 + 11, true, true},
        KeyStroke{'|', false, false}, KeyStroke{0xF6, false, false}, KeyStroke{0x1F600, true, false},
        KeyStroke{k_key_page_up, false, false}, KeyStroke{pad_key(7), false, true}, KeyStroke{'=', false, false},
        KeyStroke{'f', false, true}}) {
    EXPECT_EQ(parse_shortcut(shortcut_text(key)), key) << shortcut_text(key);
  }
  EXPECT_EQ(shortcut_text({'z', true, true}), "Ctrl+Shift+Z");
  for (const char* none : {"", "Ctrl+", "Shift+Ctrl+Q", "F25", "F0", "Num10", "QQ", "Hyper+Q", "\x01", "\xff", "\xc3"})
    EXPECT_FALSE(parse_shortcut(none)) << none;
}

TEST(KeyMap, AnotherKeyDoesItAndTheOldOneNoLonger) {
  KeyMap keys;
  keys.set(Action::undo, 0, k_q);
  ASSERT_NE(keys.action_of(k_q), nullptr);
  EXPECT_EQ(keys.action_of(k_q)->action, Action::undo);
  EXPECT_EQ(keys.action_of(k_ctrl_z), nullptr);
  EXPECT_EQ(keys.tooltip_of(Action::undo), "Take back the last step (Q)");
  keys.reset(Action::undo);
  EXPECT_EQ(keys, KeyMap()) << "nothing is left to keep";
}

TEST(KeyMap, AKeyThatIsTakenOverIsTheOtherOnesNoMore) {
  KeyMap keys;
  keys.set(Action::play, 1, {'y', true, false});
  EXPECT_EQ(keys.keys_of(Action::redo)[1].key, 0U);
  EXPECT_EQ(keys.shortcut_of(Action::redo), "Ctrl+Shift+Z");
  keys.set(Action::play, 0, {'z', true, true});
  EXPECT_EQ(keys.shortcut_of(Action::redo), "") << "it has none left";
  keys.reset(Action::redo);
  EXPECT_EQ(keys.shortcut_of(Action::redo), "Ctrl+Shift+Z");
  EXPECT_EQ(keys.shortcut_of(Action::play), "") << "and back";
}

TEST(KeyMap, TheFirstKeyIsThereWhereASecondOneIs) {
  KeyMap keys;
  keys.set(Action::redo, 0, {});
  EXPECT_EQ(keys.shortcut_of(Action::redo), "Ctrl+Y");
  keys.set(Action::redo, 1, keys.keys_of(Action::redo)[0]);
  EXPECT_EQ(keys.keys_of(Action::redo)[1].key, 0U) << "no key twice";
}

TEST(KeyMap, TwoLinesMayExchangeTheirKeys) {
  KeyMap keys;
  EXPECT_TRUE(keys.take("undo|Ctrl+Y").ok());
  EXPECT_TRUE(keys.take("redo|Ctrl+Z|Ctrl+Shift+Z").ok());
  EXPECT_TRUE(keys.take("play").ok()) << "no key at all";
  keys.settle();
  EXPECT_EQ(keys.action_of(k_ctrl_z)->action, Action::redo);
  EXPECT_EQ(keys.action_of({'y', true, false})->action, Action::undo);
  EXPECT_EQ(keys.action_of({' ', false, false}), nullptr);
  KeyMap again;
  for (const std::string& line : keys.lines()) EXPECT_TRUE(again.take(line).ok()) << line;
  again.settle();
  EXPECT_EQ(again, keys);
}

TEST(KeyMap, WhatOneLineTakesTheListsOwnLoses) {
  KeyMap keys;
  ASSERT_TRUE(keys.take("play|Ctrl+Z").ok());
  keys.settle();
  EXPECT_EQ(keys.shortcut_of(Action::undo), "");
  EXPECT_EQ(keys.action_of(k_ctrl_z)->action, Action::play);
}

}  // namespace
}  // namespace penpose::app
