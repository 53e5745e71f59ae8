#include "firmware_io/decode/described/fallback_decoder.h"

#include <gtest/gtest.h>

#include "firmware_io/decode/described/descriptor_decoder.h"
#include "firmware_io/decode/layout/protocol.h"
#include "tests/support/hands/pen_reports.h"

namespace penpose::decode {
namespace {

std::unique_ptr<FallbackDecoder> make() {
  const auto parsed = hid::parse_report_descriptor(tests::ink_descriptor());
  PenLayout pens = *find_pens(*parsed, Dialect::standard);
  return std::make_unique<FallbackDecoder>(*parsed, pens, std::make_unique<DescriptorDecoder>(pens),
                                           make_protocol_decoder("xp_pen"));
}

TEST(FallbackDecoder, SendsEachReportToTheOneThatKnowsIt) {
  const auto decoder = make();
  PenSample sample;
  sample.in_range = true;
  sample.tool = Tool::eraser;
  sample.x = 5;
  ASSERT_EQ(decoder->decode(tests::ink_pen(sample)), ReportKind::pen);
  EXPECT_EQ(decoder->sample().tool, Tool::eraser);
  EXPECT_EQ(decoder->axes().pressure.maximum, 4095);
  EXPECT_EQ(decoder->frames().back(), decoder->sample());
  // The same id with another length is not what the descriptor describes.
  tests::Report vendor = tests::ink_pen(sample);
  vendor[1] = 0xa0;
  vendor.resize(10);
  ASSERT_EQ(decoder->decode(vendor), ReportKind::pen);
  EXPECT_EQ(decoder->sample().tool, Tool::pen);
}

TEST(FallbackDecoder, ReportsOfADescribedMouseAreNotTheVendors) {
  // A mouse with report id 2 of ten bytes.
  const tests::Report mouse{0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x02, 0x09,
                            0x30, 0x75, 0x08, 0x95, 0x09, 0x81, 0x02, 0xc0};
  const auto parsed = hid::parse_report_descriptor(mouse);
  ASSERT_TRUE(parsed);
  FallbackDecoder decoder(*parsed, std::nullopt, nullptr, make_protocol_decoder("xp_pen"));
  tests::Report report{0x02, 0xa1, 1, 0, 1, 0, 1, 0, 0, 0};
  EXPECT_EQ(decoder.decode(report), ReportKind::ignored);
  report.resize(12);
  EXPECT_EQ(decoder.decode(report), ReportKind::pen);
}

TEST(FallbackDecoder, ReportsOfADescribedPadAreNotTheVendors) {
  // Keys of the tablet as report 2 of ten bytes, in an application of their own.
  const tests::Report keys{0x05, 0x0d, 0x09, 0x39, 0xa1, 0x01, 0x85, 0x02, 0x05, 0x09, 0x19,
                           0x01, 0x29, 0x48, 0x75, 0x01, 0x95, 0x48, 0x81, 0x02, 0xc0};
  const auto parsed = hid::parse_report_descriptor(keys);
  ASSERT_TRUE(parsed);
  FallbackDecoder decoder(*parsed, std::nullopt, nullptr, make_protocol_decoder("xp_pen"));
  EXPECT_EQ(decoder.decode(tests::Report{0x02, 0xa1, 1, 0, 1, 0, 1, 0, 0, 0}), ReportKind::ignored);
}

TEST(FallbackDecoder, ResetForgetsBoth) {
  const auto decoder = make();
  PenSample sample;
  sample.in_range = true;
  decoder->decode(tests::ink_pen(sample));
  decoder->reset();
  EXPECT_EQ(decoder->sample(), PenSample{});
}

}  // namespace
}  // namespace penpose::decode
