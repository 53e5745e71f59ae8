#include "firmware_io/decode/described/multitouch_decoder.h"

#include <gtest/gtest.h>

#include "tests/support/hands/hand_descriptors.h"

namespace penpose::decode {
namespace {

using tests::touch_report;

MultitouchLayout layout_of(const tests::Report& descriptor) {
  const auto parsed = hid::parse_report_descriptor(descriptor);
  EXPECT_TRUE(parsed.ok());
  auto layout = find_multitouch(*parsed);
  EXPECT_TRUE(layout.has_value());
  return std::move(*layout);
}

TEST(MultitouchDecoder, FollowsFingersByTheirNumbers) {
  MultitouchDecoder touch(layout_of(tests::touch_descriptor(2)));
  EXPECT_TRUE(touch.axes().on_screen);
  EXPECT_EQ(touch.axes().contacts, 10u);
  ASSERT_TRUE(touch.decode(touch_report({{5, 7, 100, 200}, {5, 8, 300, 400}}, 2)));
  ASSERT_EQ(touch.contacts().size(), 2u);
  const TouchContact second = touch.contacts()[1];
  ASSERT_TRUE(touch.decode(touch_report({{5, 8, 301, 401}, {0, 7, 0, 0}}, 2)));
  ASSERT_EQ(touch.contacts().size(), 1u);
  EXPECT_EQ(touch.contacts()[0], (TouchContact{second.id, 301, 401}));
}

TEST(MultitouchDecoder, FingersBeyondTheCountAreNone) {
  MultitouchDecoder touch(layout_of(tests::touch_descriptor(2)));
  ASSERT_TRUE(touch.decode(touch_report({{5, 7, 100, 200}, {5, 8, 300, 400}}, 1)));
  EXPECT_EQ(touch.contacts().size(), 1u);
}

TEST(MultitouchDecoder, AFrameMaySpanReports) {
  MultitouchDecoder touch(layout_of(tests::touch_descriptor(2)));
  EXPECT_FALSE(touch.decode(touch_report({{5, 1, 1, 1}, {5, 2, 2, 2}}, 3)));
  EXPECT_TRUE(touch.contacts().empty());
  ASSERT_TRUE(touch.decode(touch_report({{5, 3, 3, 3}, {5, 4, 4, 4}}, 0)));
  EXPECT_EQ(touch.contacts().size(), 3u);
}

TEST(MultitouchDecoder, OnlyCertifiedScreensTellOfHoveringFingers) {
  MultitouchDecoder plain(layout_of(tests::touch_descriptor(1)));
  plain.decode(touch_report({{2, 1, 5, 6}}, 1));
  EXPECT_TRUE(plain.contacts().empty());
  MultitouchDecoder certified(layout_of(tests::touch_descriptor(1, true, true)));
  certified.decode(touch_report({{6, 1, 5, 6}}, 1));
  EXPECT_EQ(certified.contacts().size(), 1u);
}

TEST(MultitouchDecoder, WithoutACountEveryReportIsAFrame) {
  MultitouchDecoder touch(layout_of(tests::touch_descriptor(2, false)));
  ASSERT_TRUE(touch.decode(touch_report({{5, 1, 1, 1}, {5, 2, 2, 2}})));
  EXPECT_EQ(touch.contacts().size(), 2u);
  EXPECT_FALSE(touch.decode(touch_report({{5, 1, 1, 1}})));
  EXPECT_FALSE(touch.decode({}));
  touch.reset();
  EXPECT_TRUE(touch.contacts().empty());
}

TEST(MultitouchDecoder, AReportWithRoomForOneFingerBringsOneWhateverTheCount) {
  MultitouchDecoder touch(layout_of(tests::touch_descriptor(1)));
  EXPECT_FALSE(touch.decode(touch_report({{5, 1, 1, 1}}, 3)));
  EXPECT_FALSE(touch.decode(touch_report({{5, 2, 2, 2}}, 0)));
  ASSERT_TRUE(touch.decode(touch_report({{5, 3, 3, 3}}, 0)));
  EXPECT_EQ(touch.contacts().size(), 3u);
  ASSERT_TRUE(touch.decode(touch_report({{0, 3, 3, 3}}, 1)));
  EXPECT_EQ(touch.contacts().size(), 2u);
}

TEST(MultitouchDecoder, APenIsNoFinger) {
  const auto parsed = hid::parse_report_descriptor(tests::ink_descriptor());
  EXPECT_FALSE(find_multitouch(*parsed).has_value());
}

}  // namespace
}  // namespace penpose::decode
