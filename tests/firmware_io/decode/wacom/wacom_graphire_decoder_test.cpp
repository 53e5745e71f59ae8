#include <gtest/gtest.h>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/wacom/wacom_pens.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/same_pen.h"

namespace penpose::decode {
namespace {

std::unique_ptr<PenDecoder> decoder_of(std::uint16_t product, std::uint16_t bus = k_bus_usb) {
  return make_wacom_graphire(*find_wacom_model(bus, k_vendor_wacom, product));
}

TEST(WacomGraphireDecoder, FollowsAPenOnItsPath) {
  auto decoder = decoder_of(0x0013);
  for (PenSample sample : tests::pen_path({10208, 7424, 511, false, -1})) {
    ASSERT_EQ(decoder->decode(tests::graphire_pen(sample)), ReportKind::pen);
    tests::expect_same_pen(decoder->sample(), sample);
  }
  EXPECT_EQ(decoder->decode(tests::graphire_pen({})), ReportKind::ignored);
}

TEST(WacomGraphireDecoder, TheMouseIsATool) {
  auto decoder = decoder_of(0x0013);
  ASSERT_EQ(decoder->decode(tests::Report{0x02, 0xd5, 1, 2, 3, 4, 0, 0x11}), ReportKind::pen);
  EXPECT_EQ(decoder->sample().tool, Tool::mouse);
  EXPECT_EQ(decoder->sample().buttons, 0b101u);
  EXPECT_EQ(decoder->sample().distance, 0x11);
  EXPECT_FALSE(decoder->sample().tip);
  auto bamboo = decoder_of(0x0017);
  bamboo->decode(tests::Report{0x02, 0xc0, 1, 2, 3, 4, 0x2a, 0, 0});
  EXPECT_EQ(bamboo->sample().distance, 0x2a);
}

TEST(WacomGraphireDecoder, OverBluetoothPressureSitsElsewhere) {
  auto decoder = decoder_of(0x0081, k_bus_bluetooth);
  EXPECT_EQ(decoder->decode(tests::Report{0x02, 0x80, 1, 0, 2, 0, 3, 0, 0}), ReportKind::ignored);
  ASSERT_EQ(decoder->decode(tests::Report{0x03, 0x89, 1, 0, 2, 0, 3, 0, 0}), ReportKind::pen);
  EXPECT_EQ(decoder->sample().pressure, 0x103);
  EXPECT_TRUE(decoder->sample().tip);
}

TEST(WacomGraphireDecoder, ShortAndForeignReportsAreIgnored) {
  auto decoder = decoder_of(0x0013);
  EXPECT_EQ(decoder->decode(tests::Report{0x02, 0x80, 1, 2, 3, 4, 5}), ReportKind::ignored);
  EXPECT_EQ(decoder->decode(tests::Report{0x63, 0x80, 1, 2, 3, 4, 5, 6}), ReportKind::ignored);
  EXPECT_EQ(decoder->decode({}), ReportKind::ignored);
}

TEST(WacomPenPartnerDecoder, ReportsWithAndWithoutProximity) {
  const auto decoder = make_wacom_penpartner(*find_wacom_model(k_bus_usb, k_vendor_wacom, 0x0000));
  ASSERT_EQ(decoder->decode(tests::Report{0x02, 0x99, 0x01, 0x73, 0x02, 0x40, 0x10}), ReportKind::pen);
  EXPECT_EQ(decoder->sample().x, 0x199);
  EXPECT_EQ(decoder->sample().y, 0x273);
  EXPECT_EQ(decoder->sample().pressure, 143);
  EXPECT_TRUE(decoder->sample().tip);
  EXPECT_EQ(decoder->sample().buttons, 1u);
  decoder->decode(tests::Report{0x02, 0x99, 0x01, 0x73, 0x02, 0x00, 0x81});
  EXPECT_FALSE(decoder->sample().tip);
  EXPECT_EQ(decoder->sample().pressure, 0);
  ASSERT_EQ(decoder->decode(tests::Report{0x01, 1, 0, 2, 0, 0xa0, 0x90}), ReportKind::pen);
  EXPECT_EQ(decoder->sample().tool, Tool::eraser);
  ASSERT_EQ(decoder->decode(tests::Report{0x01, 1, 0, 2, 0, 0x00, 0x81}), ReportKind::pen);
  EXPECT_FALSE(decoder->sample().in_range);
  EXPECT_EQ(decoder->decode(tests::Report{0x01, 1, 0, 2, 0, 0x00, 0x81}), ReportKind::ignored);
  EXPECT_EQ(decoder->decode(tests::Report{0x02, 1, 0, 2, 0, 0x00}), ReportKind::ignored);
}

}  // namespace
}  // namespace penpose::decode
