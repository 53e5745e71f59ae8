#include <gtest/gtest.h>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/wacom/wacom_pens.h"
#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/pen_reports.h"
#include "tests/support/hands/same_pen.h"

namespace penpose::decode {
namespace {

std::unique_ptr<PenDecoder> bamboo() { return make_wacom_bamboo(*find_wacom_model(k_bus_usb, k_vendor_wacom, 0x00d4)); }

TEST(WacomBambooDecoder, FollowsAPenOnItsPath) {
  auto decoder = bamboo();
  for (const PenSample& sample : tests::pen_path({14720, 9200, 1023, false, -1})) {
    ASSERT_EQ(decoder->decode(tests::bamboo_pen(sample)), ReportKind::pen);
    tests::expect_same_pen(decoder->sample(), sample);
  }
  EXPECT_EQ(decoder->decode(tests::bamboo_pen({})), ReportKind::ignored);
}

TEST(WacomBambooDecoder, ANearPenWithoutPositionKeepsTheLast) {
  auto decoder = bamboo();
  EXPECT_EQ(decoder->decode(tests::Report{0x02, 0x80, 9, 9, 9, 9, 9, 9, 3}), ReportKind::ignored);
  decoder->decode(tests::Report{0x02, 0xe1, 10, 0, 20, 0, 30, 0, 31});
  EXPECT_EQ(decoder->sample().distance, 0);
  ASSERT_EQ(decoder->decode(tests::Report{0x02, 0x80, 9, 9, 9, 9, 9, 9, 3}), ReportKind::pen);
  EXPECT_TRUE(decoder->sample().in_range);
  EXPECT_EQ(decoder->sample().x, 10);
  EXPECT_EQ(decoder->sample().pressure, 0);
  EXPECT_FALSE(decoder->sample().tip);
  EXPECT_EQ(decoder->sample().distance, 28);
}

TEST(WacomBambooDecoder, TouchReportsWithTheSameIdAreIgnored) {
  auto decoder = bamboo();
  for (const std::size_t size : {0, 1, 8, 11, 20, 64}) {
    tests::Report report(size, 0xff);
    if (size > 0) report[0] = 0x02;
    EXPECT_EQ(decoder->decode(report), ReportKind::ignored) << size;
  }
  EXPECT_EQ(decoder->decode(tests::Report{0xc0, 0xff, 1, 2, 3, 4, 5, 6, 7, 8}), ReportKind::ignored);
}

}  // namespace
}  // namespace penpose::decode
