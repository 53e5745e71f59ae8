#include "ui/app/input/screen_keyboard.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

std::string typed(ScreenKeyboard& keyboard, const std::string& label) {
  for (const auto& key : keyboard.keys()) {
    if (key.label != label) continue;
    const auto pressed = keyboard.press(key.area.middle());
    return pressed ? pressed->text : "nothing";
  }
  return "no key " + label;
}

TEST(ScreenKeyboard, KeysTypeWhatTheySayAndShiftCountsForOneLetter) {
  ScreenKeyboard keyboard;
  const Area window{0, 0, 1280, 800};
  const Area field{900, 90, 1200, 124};
  keyboard.show(window, field, 35, 6);
  EXPECT_EQ(typed(keyboard, "q"), "q");
  EXPECT_EQ(typed(keyboard, "Space"), " ");
  EXPECT_EQ(typed(keyboard, "Shift"), "");
  keyboard.show(window, field, 35, 6);
  EXPECT_EQ(typed(keyboard, "Q"), "Q");
  keyboard.show(window, field, 35, 6);
  EXPECT_EQ(typed(keyboard, "q"), "q");
  EXPECT_FALSE(keyboard.press(keyboard.area().middle() - PxPoint{0, 5000}).has_value());
}

TEST(ScreenKeyboard, ItLeavesTheFieldInSightAndItsKeysAreLargeEnough) {
  for (const Area& window : {Area{0, 0, 1280, 800}, Area{0, 0, 640, 400}}) {
    for (const double y : {20.0, window.bottom - 60}) {
      ScreenKeyboard keyboard;
      const Area field{100, y, 300, y + 34};
      keyboard.show(window, field, 34, 6);
      EXPECT_TRUE(keyboard.area().bottom <= field.top || keyboard.area().top >= field.bottom) << y;
      EXPECT_GE(keyboard.area().left, window.left);
      EXPECT_LE(keyboard.area().right, window.right);
      for (const auto& key : keyboard.keys()) {
        EXPECT_GE(key.area.width(), 34) << key.label;
        EXPECT_GE(key.area.height(), 34) << key.label;
      }
    }
  }
}

}  // namespace
}  // namespace penpose::app
