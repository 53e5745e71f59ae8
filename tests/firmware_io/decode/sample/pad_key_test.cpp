#include "firmware_io/decode/sample/pad_key.h"

#include <gtest/gtest.h>
#include <set>

namespace penpose::decode {
namespace {

TEST(PadKey, IsOrderedByLinuxsCode) {
  std::uint16_t last = 0;
  for (unsigned i = 0; i < static_cast<unsigned>(PadKey::extra1); ++i) {
    const std::uint16_t code = key_code(static_cast<PadKey>(i));
    EXPECT_GT(code, last) << i;
    last = code;
  }
}

TEST(PadKey, EveryNumberHasAKeyAndANameOfItsOwn) {
  std::set<PadKey> keys;
  std::set<std::string> names;
  for (unsigned i = 0; i < k_numbered_keys; ++i) {
    keys.insert(numbered_key(i));
    names.insert(key_name(numbered_key(i)));
  }
  EXPECT_EQ(keys.size(), k_numbered_keys);
  EXPECT_EQ(names.size(), k_numbered_keys);
  EXPECT_EQ(key_name(numbered_key(0)), "BTN_0");
  EXPECT_EQ(key_name(numbered_key(9)), "BTN_9");
  EXPECT_EQ(key_name(numbered_key(10)), "BTN_A");
  EXPECT_EQ(key_name(numbered_key(15)), "BTN_Z");
  EXPECT_EQ(key_name(numbered_key(16)), "BTN_BASE");
  EXPECT_EQ(key_name(numbered_key(17)), "BTN_BASE2");
  EXPECT_EQ(key_name(numbered_key(22)), "BTN_TRIGGER_HAPPY1");
}

TEST(PadKey, NamesOfASetStandInTheOrderOfTheirCodes) {
  EXPECT_EQ(key_names({}), "-");
  EXPECT_EQ(key_names({PadKey::button_config, PadKey::program1, PadKey::a, PadKey::base, PadKey::info}),
            "KEY_PROG1+BTN_BASE+BTN_A+0x166+KEY_BUTTONCONFIG");
}

TEST(PadKey, NumbersBeyondTheModelsAreNotThere) {
  EXPECT_EQ(key_names(numbered_keys(0b1011, 2)), "BTN_0+BTN_1");
  EXPECT_TRUE(numbered_keys(~std::uint64_t{0}, 0).empty());
  EXPECT_EQ(numbered_keys(~std::uint64_t{0}, 1000), numbered_keys(~std::uint64_t{0}, k_numbered_keys));
}

}  // namespace
}  // namespace penpose::decode
