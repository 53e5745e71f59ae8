#include "firmware_io/decode/wacom/wacom_usages.h"

#include <gtest/gtest.h>

#include "tests/support/hands/hand_descriptors.h"

namespace penpose::decode {
namespace {

TEST(WacomUsages, OfFingersStandForStandardOnes) {
  EXPECT_EQ(standard_usage(hid::usage(0xff00, 0x0130)), hid::k_x);
  EXPECT_EQ(standard_usage(hid::usage(0xff0d, 0x0131)), hid::k_y);
  EXPECT_EQ(standard_usage(hid::usage(0xff00, 0x0042)), hid::k_tip_switch);
  EXPECT_EQ(standard_usage(hid::k_x), hid::k_x);
  EXPECT_EQ(standard_usage(k_fingers_valid), k_fingers_valid);
  EXPECT_EQ(standard_usage(k_pad_first_key), k_pad_first_key);
  EXPECT_EQ(standard_usage(k_wacom_serial_high), k_wacom_serial_high);
  EXPECT_EQ(standard_usage(hid::usage(0xff11, 0x0042)), hid::usage(0xff11, 0x0042));  // G11 mirrors nothing
}

TEST(WacomUsages, CollectionsTellWhatAFieldIsOf) {
  const auto pad = hid::parse_report_descriptor(tests::wacom_pad_descriptor());
  ASSERT_TRUE(pad.ok());
  EXPECT_TRUE(is_wacom_pad(*pad, pad->fields.front()));
  EXPECT_TRUE(is_wacom_function_keys(*pad, pad->fields.front()));
  EXPECT_TRUE(is_wacom_pen(*pad, pad->fields.front()));  // by its application; the pad goes first
  EXPECT_FALSE(is_wacom_finger(*pad, pad->fields.front()));
  const auto touch = hid::parse_report_descriptor(tests::touch_descriptor(1));
  ASSERT_TRUE(touch.ok());
  EXPECT_TRUE(is_wacom_finger(*touch, touch->fields.front()));
  EXPECT_FALSE(is_wacom_pad(*touch, touch->fields.front()));
}

}  // namespace
}  // namespace penpose::decode
