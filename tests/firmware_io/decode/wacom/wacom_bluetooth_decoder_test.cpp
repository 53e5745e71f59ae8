#include <algorithm>
#include <gtest/gtest.h>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/wacom/wacom_pens.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

std::unique_ptr<PenDecoder> decoder_of(std::uint16_t product) {
  return make_wacom_bluetooth(*find_wacom_model(k_bus_bluetooth, k_vendor_wacom, product));
}

/// A report with room for all frames, serial and tool number.
tests::Report pro_report(std::uint32_t tool) {
  tests::Report report(361);
  report[0] = 0x80;
  report[99] = 0x21;
  // Upper half 0x001xxxxx: the mark of electromagnetic pens with the tool number's upper bits.
  const std::uint32_t upper = 0x00100000u | (tool & 0xff000u);
  for (std::size_t i = 0; i < 4; ++i) report[103 + i] = static_cast<std::uint8_t>(upper >> (8 * i));
  report[107] = static_cast<std::uint8_t>(tool);
  report[108] = static_cast<std::uint8_t>((tool >> 8) & 0x0f);
  return report;
}

void set_frame(tests::Report& report, std::size_t index, const tests::Report& frame) {
  std::copy(frame.begin(), frame.end(), report.begin() + 1 + static_cast<std::ptrdiff_t>(index * frame.size()));
}

TEST(WacomBluetoothDecoder, EveryValidFrameIsASample) {
  auto decoder = decoder_of(0x0360);
  tests::Report report = pro_report(0x10802);
  set_frame(report, 0, {0xe0, 10, 0, 20, 0, 0, 0, 5, 0xfb, 0, 0, 0, 0, 40});
  set_frame(report, 1, {0xe3, 11, 0, 21, 0, 44, 1, 6, 0xfa, 0xd4, 0xfe, 0, 0, 0});
  ASSERT_EQ(decoder->decode(report), ReportKind::pen);
  ASSERT_EQ(decoder->frames().size(), 2u);
  EXPECT_FALSE(decoder->frames()[0].tip);
  EXPECT_EQ(decoder->frames()[0].distance, 40);
  const PenSample& last = decoder->sample();
  EXPECT_EQ(last.x, 11);
  EXPECT_EQ(last.y, 21);
  EXPECT_EQ(last.pressure, 300);
  EXPECT_EQ(last.tilt_x, 6);
  EXPECT_EQ(last.tilt_y, -6);
  EXPECT_EQ(last.rotation, -300 + 450);
  EXPECT_TRUE(last.tip);
  EXPECT_EQ(last.buttons, 1u);
  EXPECT_EQ(last.tool, Tool::pen);
  EXPECT_EQ(last.tool_id, 0x100802u);
}

TEST(WacomBluetoothDecoder, LeavingEndsTheReport) {
  auto decoder = decoder_of(0x0360);
  tests::Report near = pro_report(0x1080a);
  set_frame(near, 0, {0xf0, 10, 0, 20, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  decoder->decode(near);
  EXPECT_EQ(decoder->sample().tool, Tool::eraser);
  tests::Report away = pro_report(0);
  set_frame(away, 0, {0x80, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  set_frame(away, 1, {0xe0, 99, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  ASSERT_EQ(decoder->decode(away), ReportKind::pen);
  EXPECT_EQ(decoder->frames().size(), 1u);
  EXPECT_FALSE(decoder->sample().in_range);
  EXPECT_EQ(decoder->decode(away), ReportKind::ignored);
}

TEST(WacomBluetoothDecoder, TheSmallTabletsHaveShorterFrames) {
  auto decoder = decoder_of(0x0377);
  tests::Report report(46);
  report[0] = 0x81;
  set_frame(report, 0, {0xe1, 10, 0, 20, 0, 0x64, 0, 3});
  ASSERT_EQ(decoder->decode(report), ReportKind::pen);
  EXPECT_EQ(decoder->sample().pressure, 100);
  EXPECT_EQ(decoder->sample().distance, 3);
  EXPECT_FALSE(decoder->axes().tilt_x.present);
}

TEST(WacomBluetoothDecoder, ShortAndForeignReportsAreIgnored) {
  auto decoder = decoder_of(0x0360);
  tests::Report report = pro_report(0x10802);
  set_frame(report, 0, {0xe0, 10, 0, 20, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  report[0] = 0x10;
  EXPECT_EQ(decoder->decode(report), ReportKind::ignored);
  report[0] = 0x80;
  report.resize(108);
  EXPECT_EQ(decoder->decode(report), ReportKind::ignored);
}

}  // namespace
}  // namespace penpose::decode
