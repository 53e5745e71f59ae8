#include "firmware_io/decode/described/descriptor_decoder.h"

#include <gtest/gtest.h>

#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/same_pen.h"

namespace penpose::decode {
namespace {

DescriptorDecoder ink_decoder() {
  const auto parsed = hid::parse_report_descriptor(tests::ink_descriptor());
  EXPECT_TRUE(parsed.ok());
  return DescriptorDecoder(*find_pens(*parsed, Dialect::standard));
}

/// What of a sample a Windows Ink pen can say.
void expect_same(const PenSample& got, const PenSample& wanted) {
  EXPECT_EQ(got.in_range, wanted.in_range);
  if (!wanted.in_range) return;
  tests::expect_same_pen(got, wanted);
  EXPECT_EQ(got.tilt_x, wanted.tilt_x);
  EXPECT_EQ(got.tilt_y, wanted.tilt_y);
}

TEST(DescriptorDecoder, FollowsAPenOnItsPath) {
  DescriptorDecoder decoder = ink_decoder();
  for (const PenSample& sample : tests::pen_path({24188, 15360, 4095, true, -1})) {
    ASSERT_EQ(decoder.decode(tests::ink_pen(sample)), ReportKind::pen);
    expect_same(decoder.sample(), sample);
  }
}

TEST(DescriptorDecoder, AReportOfNothingNearIsNoSample) {
  DescriptorDecoder decoder = ink_decoder();
  EXPECT_EQ(decoder.decode(tests::ink_pen({})), ReportKind::ignored);
}

TEST(DescriptorDecoder, ClampsToTheLogicalRange) {
  DescriptorDecoder decoder = ink_decoder();
  PenSample sample;
  sample.in_range = true;
  sample.tool = Tool::pen;
  sample.x = 30000;
  sample.pressure = 5000;
  sample.tilt_x = -9500;
  ASSERT_EQ(decoder.decode(tests::ink_pen(sample)), ReportKind::pen);
  EXPECT_EQ(decoder.sample().x, 24188);
  EXPECT_EQ(decoder.sample().pressure, 4095);
  EXPECT_EQ(decoder.sample().tilt_x, -9000);
}

TEST(DescriptorDecoder, TurningThePenRoundWhileNearEndsContact) {
  DescriptorDecoder decoder = ink_decoder();
  PenSample sample;
  sample.in_range = sample.tip = true;
  sample.tool = Tool::pen;
  decoder.decode(tests::ink_pen(sample));
  EXPECT_TRUE(decoder.sample().tip);
  sample.tool = Tool::eraser;
  sample.tip = false;
  decoder.decode(tests::ink_pen(sample));
  EXPECT_EQ(decoder.sample().tool, Tool::eraser);
  EXPECT_FALSE(decoder.sample().tip);
}

/// A pen with X, Y and what `switches` declares, one bit each of the second byte.
DescriptorDecoder decoder_with(const tests::Report& switches, std::uint8_t flags = 0x02) {
  tests::Report bytes{0x05, 0x0d, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x01, 0x15, 0x00, 0x25, 0x01, 0x75, 0x01};
  for (const std::uint8_t usage : switches) bytes.insert(bytes.end(), {0x09, usage});
  const auto count = static_cast<std::uint8_t>(switches.size());
  bytes.insert(bytes.end(), {0x95, count, 0x81, 0x02, 0x95, static_cast<std::uint8_t>(8 - count), 0x81, 0x03});
  bytes.insert(bytes.end(), {0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x25, 0x64, 0x75, 0x08, 0x95, 0x02, 0x81, flags});
  bytes.insert(bytes.end(), {0x05, 0x0d, 0x09, 0x30, 0x95, 0x01, 0x81, 0x02, 0xc0});
  const auto parsed = hid::parse_report_descriptor(bytes);
  EXPECT_TRUE(parsed.ok());
  return DescriptorDecoder(*find_pens(*parsed, Dialect::standard));
}

TEST(DescriptorDecoder, WithoutInvertTheEraserBitAloneMakesAnEraser) {
  DescriptorDecoder decoder = decoder_with({0x42, 0x45, 0x32});
  decoder.decode(tests::Report{1, 0b100, 10, 10, 0});
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
  decoder.decode(tests::Report{1, 0b110, 10, 10, 5});
  EXPECT_EQ(decoder.sample().tool, Tool::eraser);
  EXPECT_TRUE(decoder.sample().tip);
  decoder.decode(tests::Report{1, 0b100, 10, 10, 0});
  EXPECT_FALSE(decoder.sample().tip);
  decoder.decode(tests::Report{1, 0b100, 10, 10, 0});
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
}

TEST(DescriptorDecoder, AnEraserButtonHeldInTheAirTouchesNothing) {
  DescriptorDecoder decoder = decoder_with({0x42, 0x45, 0x32});
  for (const int pressure : {0, 5, 0}) {
    decoder.decode(tests::Report{1, 0b110, 10, 10, static_cast<std::uint8_t>(pressure)});
    EXPECT_EQ(decoder.sample().tool, Tool::eraser);
    EXPECT_EQ(decoder.sample().tip, pressure > 0);
  }
}

TEST(DescriptorDecoder, WithoutATipSwitchPressureDecides) {
  DescriptorDecoder decoder = decoder_with({0x32});
  decoder.decode(tests::Report{1, 1, 10, 10, 12});
  EXPECT_FALSE(decoder.sample().tip);
  decoder.decode(tests::Report{1, 1, 10, 10, 13});
  EXPECT_TRUE(decoder.sample().tip);
}

TEST(DescriptorDecoder, WithoutInRangeAReportMeansNear) {
  DescriptorDecoder decoder = decoder_with({0x42});
  EXPECT_EQ(decoder.decode(tests::Report{1, 0, 10, 20, 0}), ReportKind::pen);
  EXPECT_TRUE(decoder.sample().in_range);
  EXPECT_EQ(decoder.sample().y, 20);
}

TEST(DescriptorDecoder, ANullStateKeepsTheLastValue) {
  DescriptorDecoder decoder = decoder_with({0x42, 0x32}, 0x42);
  decoder.decode(tests::Report{1, 2, 50, 60, 0});
  decoder.decode(tests::Report{1, 2, 200, 61, 0});
  EXPECT_EQ(decoder.sample().x, 50);
  EXPECT_EQ(decoder.sample().y, 61);
}

TEST(DescriptorDecoder, ResetForgetsTheTool) {
  DescriptorDecoder decoder = decoder_with({0x42, 0x45, 0x32});
  decoder.decode(tests::Report{1, 0b110, 10, 10, 5});
  decoder.reset();
  EXPECT_EQ(decoder.sample(), PenSample{});
  decoder.decode(tests::Report{1, 0b101, 10, 10, 5});
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
}

}  // namespace
}  // namespace penpose::decode
