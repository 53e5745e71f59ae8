#include "firmware_io/decode/described/mode_light.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

TEST(ModeLight, APressMovesOnHoweverLongItLasts) {
  ModeLight light;
  EXPECT_EQ(light.press(false, 4), 0);
  EXPECT_EQ(light.press(true, 4), 1);
  EXPECT_EQ(light.press(true, 4), 1);
  EXPECT_EQ(light.press(false, 4), 1);
  EXPECT_EQ(light.press(true, 4), 2);
}

TEST(ModeLight, AfterTheLastComesTheFirst) {
  ModeLight light;
  for (int i = 0; i < 3; ++i) {
    light.press(true, 3);
    light.press(false, 3);
  }
  EXPECT_EQ(light.press(false, 3), 0);
  EXPECT_EQ(light.press(true, 0), 0);
}

TEST(ModeLight, KeysOfTheirOwnChooseTheLowestOfThem) {
  ModeLight light;
  EXPECT_EQ(light.choose(0b100, 3), 2);
  EXPECT_EQ(light.choose(0, 3), 2);
  EXPECT_EQ(light.choose(0b110, 3), 1);
  EXPECT_EQ(light.choose(0b1000, 3), 1);
  light.reset();
  EXPECT_EQ(light.choose(0, 3), 0);
}

}  // namespace
}  // namespace penpose::decode
