#include "firmware_io/decode/table/told_ranges.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/decoder_factory.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

/// x up to 50800, y up to 31750, pressure up to 8191, 5080 lines an inch.
constexpr const char* k_told = "70c600067c00ff1fd81303020100";

/// A made-up tablet that no table has.
DeviceIdentity unknown(const std::string& told) {
  DeviceIdentity device =
      tests::device(0x256c, 0x2fff, {0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x85, 0x08, 0x75, 0x08, 0x95,
                                     0x0b, 0x15, 0x00, 0x26, 0xff, 0x00, 0x09, 0x01, 0x81, 0x02, 0xc0});
  device.strings[k_ranges_string] = told;
  return device;
}

TEST(ToldRanges, ATabletThatNoTableHasIsReadByWhatItTells) {
  const auto made = make_decoder(unknown(k_told));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->method, "protocol huion_giano");
  EXPECT_EQ(made->guess, "");
  const PenAxes& axes = made->decoder->axes();
  EXPECT_EQ(axes.x.maximum, 50800);
  EXPECT_EQ(axes.y.maximum, 31750);
  EXPECT_EQ(axes.pressure.maximum, 8191);
  EXPECT_NEAR(axes.x.units_per_mm, 200, 1e-9);
  ASSERT_EQ(made->decoder->decode(tests::Report{8, 0x81, 0x10, 0x27, 0x20, 0x4e, 0xe8, 0x03, 0, 0, 5, 0xfb}),
            ReportKind::pen);
  EXPECT_EQ(made->decoder->sample().x, 10000);
  EXPECT_EQ(made->decoder->sample().y, 20000);
  EXPECT_EQ(made->decoder->sample().pressure, 1000);
  EXPECT_TRUE(made->decoder->sample().tip);
}

TEST(ToldRanges, WhatTellsNoRangesIsNoPen) {
  for (const char* told : {"", "waking", "70c600067c00ff1fd8", "000000067c00ff1fd813", "70c6020067c00ff1fd813",
                           "70c6ff067c00ff1fd813", "70c600067c000000d813", "zzc600067c00ff1fd813"}) {
    EXPECT_FALSE(make_decoder(unknown(told))) << told;
  }
  DeviceIdentity other = unknown(k_told);
  other.vendor = 0x1234;
  EXPECT_FALSE(make_decoder(other));
  DeviceIdentity keyboard = unknown(k_told);
  keyboard.report_descriptor[8] = 0x03;
  EXPECT_FALSE(make_decoder(keyboard)) << "another interface of the same tablet";
  keyboard.report_descriptor.clear();
  EXPECT_FALSE(make_decoder(keyboard));
}

TEST(ToldRanges, TextStaysTextAndOtherBytesAreKept) {
  EXPECT_EQ(ranges_text(base::Bytes{}), "");
  const tests::Report text{'o', 0, 'k', 0};
  EXPECT_EQ(ranges_text(text), "ok");
  const tests::Report bytes{0x70, 0xc6, 0x00, 0x06, 0x7c};
  EXPECT_EQ(ranges_text(bytes), "70c600067c");
}

}  // namespace
}  // namespace penpose::decode
