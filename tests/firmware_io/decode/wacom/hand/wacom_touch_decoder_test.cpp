#include "firmware_io/decode/wacom/hand/wacom_touch_decoder.h"

#include <gtest/gtest.h>

#include "tests/support/hands/hand_descriptors.h"

namespace penpose::decode {
namespace {

using tests::Report;

TouchAxes axes_of(unsigned contacts) { return {{0, 4096, 0, true}, {0, 4096, 0, true}, contacts, false}; }

using tests::wacom_touch64;

TEST(WacomTouchDecoder, FingersWithoutAMessageStayWhereTheyWere) {
  WacomTouchDecoder touch(WacomTouch::intuos, axes_of(16));
  ASSERT_TRUE(touch.decode(wacom_touch64({{2, true, 100, 200}, {5, true, 4095, 4094}})));
  ASSERT_EQ(touch.contacts().size(), 2u);
  const TouchContact second = touch.contacts()[1];
  EXPECT_EQ(second.x, 4095);
  EXPECT_EQ(second.y, 4094);
  ASSERT_TRUE(touch.decode(wacom_touch64({{2, false, 0, 0}})));
  ASSERT_EQ(touch.contacts().size(), 1u);
  EXPECT_EQ(touch.contacts()[0], second);
  touch.reset();
  EXPECT_TRUE(touch.contacts().empty());
}

TEST(WacomTouchDecoder, OtherMessagesAreNoFingers) {
  WacomTouchDecoder touch(WacomTouch::intuos, axes_of(16));
  Report report = wacom_touch64({{128, true, 1, 1}, {1, true, 1, 1}, {18, true, 1, 1}});
  touch.decode(report);
  EXPECT_TRUE(touch.contacts().empty());
  report.resize(63);
  EXPECT_FALSE(touch.decode(report));
}

TEST(WacomTouchDecoder, TwoFingersInThirtySecondsOfAUnit) {
  WacomTouchDecoder touch(WacomTouch::bamboo, axes_of(2), true);
  Report report(20);
  report[0] = 0x02;
  report[3] = 0x81;
  report[4] = 0x02;
  report[6] = 0x03;
  report[12] = 0x80;
  report[13] = 0x07;
  ASSERT_TRUE(touch.decode(report));
  ASSERT_EQ(touch.contacts().size(), 2u);
  EXPECT_EQ(touch.contacts()[0].x, 0x102 << 5);
  EXPECT_EQ(touch.contacts()[0].y, 0x03 << 5);
  EXPECT_EQ(touch.contacts()[1].x, 0x07 << 5);
  // With the first bit of byte 1 the second finger is told of one byte earlier.
  report[1] = 0x80;
  ASSERT_TRUE(touch.decode(report));
  EXPECT_EQ(touch.contacts().size(), 1u);
}

TEST(WacomTouchDecoder, FramesOfAScreenSpanReports) {
  WacomTouchDecoder touch(WacomTouch::display, axes_of(10));
  const auto report_of = [](std::uint8_t count, std::uint8_t first_id) {
    Report report(64);
    report[0] = 1;
    report[61] = count;
    for (std::uint8_t i = 0; i < 4; ++i) {
      const std::size_t at = 1U + 14U * i;
      report[at] = 1;
      report[at + 1] = static_cast<std::uint8_t>(first_id + i);
      report[at + 2] = static_cast<std::uint8_t>(first_id + i);
      report[at + 6] = 9;
    }
    return report;
  };
  touch.decode(report_of(6, 1));
  EXPECT_EQ(touch.contacts().size(), 4u);
  touch.decode(report_of(0, 5));
  ASSERT_EQ(touch.contacts().size(), 6u);
  EXPECT_EQ(touch.contacts()[5].x, 6);
  EXPECT_EQ(touch.contacts()[5].y, 9);
}

TEST(WacomTouchDecoder, NotebooksTellOneFingerThreeWays) {
  WacomTouchDecoder touch(WacomTouch::tablet_pc, axes_of(1));
  ASSERT_TRUE(touch.decode(Report{0x01, 0x10, 0x20, 0x30, 0x40}));
  ASSERT_EQ(touch.contacts().size(), 1u);
  EXPECT_EQ(touch.contacts()[0].x, 0x2010);
  EXPECT_EQ(touch.contacts()[0].y, 0x4030);
  ASSERT_TRUE(touch.decode(Report{0x06, 0x00, 1, 0, 2, 0}));
  EXPECT_TRUE(touch.contacts().empty());
  ASSERT_TRUE(touch.decode(Report{0x10, 0x00, 0x01, 5, 0, 6, 0, 0, 0, 0}));
  ASSERT_EQ(touch.contacts().size(), 1u);
  EXPECT_EQ(touch.contacts()[0].x, 5);
  EXPECT_FALSE(touch.decode(Report{0x55, 1, 2, 3, 4, 5}));
}

TEST(WacomTouchDecoder, ShortReportsOfManyFingersGiveWhatTheyHave) {
  WacomTouchDecoder touch(WacomTouch::tablet_pc_many_bare, axes_of(10));
  Report report{0x0d, 0, 5, 1, 7, 0, 10, 0, 20, 0};
  ASSERT_TRUE(touch.decode(report));
  ASSERT_EQ(touch.contacts().size(), 1u);
  EXPECT_EQ(touch.contacts()[0].x, 10);
  EXPECT_EQ(touch.contacts()[0].y, 20);
}

}  // namespace
}  // namespace penpose::decode
