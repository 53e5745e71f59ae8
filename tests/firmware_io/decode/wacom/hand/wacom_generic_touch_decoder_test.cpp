#include "firmware_io/decode/wacom/hand/wacom_generic_touch_decoder.h"

#include <gtest/gtest.h>

#include "tests/support/hands/hand_descriptors.h"

namespace penpose::decode {
namespace {

using tests::touch_report;

std::unique_ptr<WacomGenericTouchDecoder> touch_of(const tests::Report& descriptor,
                                                   std::shared_ptr<TouchSwitch> gate = nullptr) {
  const auto parsed = hid::parse_report_descriptor(descriptor);
  EXPECT_TRUE(parsed.ok());
  auto layout = find_wacom_fingers(*parsed);
  EXPECT_TRUE(layout.has_value());
  return std::make_unique<WacomGenericTouchDecoder>(std::move(*layout), std::move(gate));
}

TEST(WacomGenericTouchDecoder, AFrameMaySpanReports) {
  const auto touch = touch_of(tests::touch_descriptor(2));
  EXPECT_EQ(touch->axes().x.maximum, 9600);
  EXPECT_FALSE(touch->decode(touch_report({{5, 1, 100, 200}, {5, 2, 300, 400}}, 3)));
  EXPECT_TRUE(touch->contacts().empty());
  ASSERT_TRUE(touch->decode(touch_report({{5, 3, 500, 600}, {5, 9, 1, 1}}, 0)));
  ASSERT_EQ(touch->contacts().size(), 3u);
  EXPECT_EQ(touch->contacts()[2].x, 500);
  ASSERT_TRUE(touch->decode(touch_report({{0, 2, 0, 0}, {5, 1, 101, 201}}, 2)));
  ASSERT_EQ(touch->contacts().size(), 2u);
  EXPECT_EQ(touch->contacts()[0].x, 101);
}

TEST(WacomGenericTouchDecoder, APalmIsNoFinger) {
  const auto touch = touch_of(tests::touch_descriptor(1));
  ASSERT_TRUE(touch->decode(touch_report({{5, 1, 10, 20}}, 1)));
  EXPECT_EQ(touch->contacts().size(), 1u);
  ASSERT_TRUE(touch->decode(touch_report({{1, 1, 10, 20}}, 1)));
  EXPECT_TRUE(touch->contacts().empty());
}

TEST(WacomGenericTouchDecoder, NothingComesWhileTheSwitchIsOff) {
  const auto gate = std::make_shared<TouchSwitch>();
  gate->present = true;
  gate->on = true;
  const auto touch = touch_of(tests::touch_descriptor(1), gate);
  EXPECT_TRUE(gate->has_touch);
  touch->decode(touch_report({{5, 1, 10, 20}}, 1));
  EXPECT_EQ(touch->contacts().size(), 1u);
  gate->on = false;
  ASSERT_TRUE(touch->decode(touch_report({{5, 1, 11, 21}}, 1)));
  EXPECT_TRUE(touch->contacts().empty());
  EXPECT_FALSE(touch->decode(touch_report({{5, 1, 12, 22}}, 1)));
}

TEST(WacomGenericTouchDecoder, AFrameCanBeEndedEarly) {
  const auto touch = touch_of(tests::touch_descriptor(2));
  EXPECT_FALSE(touch->end_early());
  EXPECT_FALSE(touch->decode(touch_report({{5, 1, 100, 200}, {5, 2, 300, 400}}, 3)));
  EXPECT_TRUE(touch->end_early());
  EXPECT_EQ(touch->contacts().size(), 2u);
  EXPECT_FALSE(touch->end_early());
}

TEST(WacomGenericTouchDecoder, ShortReportsAndOtherIdsSayNothing) {
  const auto touch = touch_of(tests::touch_descriptor(2));
  EXPECT_FALSE(touch->decode({}));
  EXPECT_FALSE(touch->decode(touch_report({{5, 1, 10, 20}}, 1)));
  tests::Report other = touch_report({{5, 1, 10, 20}, {0, 0, 0, 0}}, 1);
  other[0] = 9;
  EXPECT_FALSE(touch->decode(other));
}

}  // namespace
}  // namespace penpose::decode
