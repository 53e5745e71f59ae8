#include "firmware_io/decode/wacom/wacom_display_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/wacom/wacom_axes.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/same_pen.h"

namespace penpose::decode {
namespace {

WacomDisplayDecoder decoder_of(std::uint16_t product) {
  return WacomDisplayDecoder(*find_wacom_model(k_bus_usb, k_vendor_wacom, product));
}

TEST(WacomDisplayDecoder, FollowsAPenOverADtus) {
  auto decoder = decoder_of(0x0336);
  for (const PenSample& sample : tests::pen_path({23672, 13403, 1023, false, 10})) {
    ASSERT_EQ(decoder.decode(tests::dtus_pen(sample)), ReportKind::pen);
    tests::expect_same_pen(decoder.sample(), sample);
  }
  EXPECT_EQ(decoder.decode(tests::dtus_pen({})), ReportKind::ignored);
  EXPECT_EQ(decoder.decode(tests::Report{0x15, 0x05, 0, 0, 0, 0, 0}), ReportKind::ignored);
}

TEST(WacomDisplayDecoder, FollowsAPenOverATabletPc) {
  auto decoder = decoder_of(0x00ec);
  for (const PenSample& sample : tests::pen_path({25710, 14500, 255, false, -1})) {
    ASSERT_EQ(decoder.decode(tests::tablet_pc_pen(sample)), ReportKind::pen);
    tests::expect_same_pen(decoder.sample(), sample);
  }
}

TEST(WacomDisplayDecoder, ATabletPcSettlesTheToolOnEntering) {
  auto decoder = decoder_of(0x00ec);
  decoder.decode(tests::Report{0x02, 0x20, 1, 0, 1, 0, 0, 0});
  decoder.decode(tests::Report{0x02, 0x28, 1, 0, 1, 0, 0, 0});
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
}

/// A report of the PL family: seven bits of position a byte, pressure as a signed number.
tests::Report pl_pen(bool near, std::int32_t x, std::int32_t y, std::int32_t pressure, std::uint8_t state) {
  const std::int32_t raw = pressure - 256;  // nine bits, signed
  return {0x02,
          static_cast<std::uint8_t>((near ? 0x40 : 0) | ((x >> 14) & 3)),
          static_cast<std::uint8_t>((x >> 7) & 0x7f),
          static_cast<std::uint8_t>(x & 0x7f),
          static_cast<std::uint8_t>(state | ((y >> 14) & 3) | ((raw & 1) << 6) | (((raw >> 1) & 1) << 2)),
          static_cast<std::uint8_t>((y >> 7) & 0x7f),
          static_cast<std::uint8_t>(y & 0x7f),
          static_cast<std::uint8_t>((raw >> 2) & 0x7f)};
}

TEST(WacomDisplayDecoder, PlPositionsAndPressures) {
  auto decoder = decoder_of(0x0039);
  for (const std::int32_t pressure : {0, 1, 2, 3, 127, 255, 256, 300, 511}) {
    ASSERT_EQ(decoder.decode(pl_pen(true, 34000, 27000, pressure, 0x08)), ReportKind::pen);
    EXPECT_EQ(decoder.sample().pressure, pressure);
    EXPECT_EQ(decoder.sample().x, 34000);
    EXPECT_EQ(decoder.sample().y, 27000);
    EXPECT_TRUE(decoder.sample().tip);
  }
}

TEST(WacomDisplayDecoder, OnAPlTheSecondButtonAndTheEraserShareABit) {
  auto decoder = decoder_of(0x0039);
  decoder.decode(pl_pen(true, 1, 1, 0, 0x00));
  decoder.decode(pl_pen(true, 1, 1, 0, 0x20));
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
  EXPECT_EQ(decoder.sample().buttons, 2u);
  EXPECT_EQ(decoder.decode(pl_pen(false, 0, 0, 0, 0)), ReportKind::pen);
  decoder.decode(pl_pen(true, 1, 1, 0, 0x20));
  EXPECT_EQ(decoder.sample().tool, Tool::eraser);
  EXPECT_EQ(decoder.sample().buttons, 0u);
  decoder.decode(pl_pen(true, 1, 1, 0, 0x00));
  EXPECT_EQ(decoder.sample().tool, Tool::pen);
}

TEST(WacomDisplayDecoder, CintiqPartnerAndDtu) {
  auto ptu = decoder_of(0x0003);
  ptu.decode(tests::Report{0x02, 0x2c, 1, 2, 3, 4, 5, 1});
  EXPECT_EQ(ptu.sample().tool, Tool::eraser);
  EXPECT_TRUE(ptu.sample().tip);
  EXPECT_EQ(ptu.sample().pressure, 0x105);
  auto dtu = decoder_of(0x00ce);
  dtu.decode(tests::Report{0x02, 0x33, 1, 2, 3, 4, 5, 1});
  EXPECT_EQ(dtu.sample().tool, Tool::pen);
  EXPECT_EQ(dtu.sample().x, 0x201);
  EXPECT_EQ(dtu.sample().pressure, 0x105);
  EXPECT_EQ(dtu.sample().buttons, 3u);
  EXPECT_TRUE(dtu.sample().tip);
  EXPECT_EQ(dtu.decode(tests::Report{0x02, 0x00, 1, 2, 3, 4, 5, 1}), ReportKind::pen);
  EXPECT_FALSE(dtu.sample().in_range);
}

TEST(WacomDisplayDecoder, ShortReportsAreIgnored) {
  for (const int product : {0x0030, 0x0003, 0x00ce, 0x00fb, 0x0090}) {
    auto decoder = decoder_of(static_cast<std::uint16_t>(product));
    for (std::size_t size = 0; size < 7; ++size) {
      tests::Report report(size, 0xff);
      if (size > 0) report[0] = product == 0x00fb ? 0x11 : 0x02;
      EXPECT_EQ(decoder.decode(report), ReportKind::ignored);
    }
  }
}

TEST(WacomDisplayDecoder, TakesAxesThatTheDescriptorStates) {
  const WacomModel& model = *find_wacom_model(k_bus_usb, k_vendor_wacom, 0x0090);
  PenAxes axes = wacom_axes(model);
  axes.pressure.maximum = 1023;
  EXPECT_EQ(WacomDisplayDecoder(model, axes).axes().pressure.maximum, 1023);
}

}  // namespace
}  // namespace penpose::decode
