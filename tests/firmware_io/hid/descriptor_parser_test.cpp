#include <gtest/gtest.h>
#include <vector>

#include "firmware_io/hid/report_descriptor.h"

namespace penpose::hid {
namespace {

using Bytes = std::vector<std::uint8_t>;

ReportDescriptor parsed(const Bytes& bytes, Strictness strictness = Strictness::exact) {
  auto result = parse_report_descriptor(bytes, strictness);
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().line());
  return result ? std::move(result).value() : ReportDescriptor{};
}

std::string place_of_error(const Bytes& bytes) {
  const auto result = parse_report_descriptor(bytes);
  return result ? "no error" : result.error().place;
}

// The mouse of HID 1.11, appendix E.10.
const Bytes k_boot_mouse{0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x09, 0x01, 0xa1, 0x00, 0x05, 0x09, 0x19,
                         0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01, 0x95, 0x03, 0x75, 0x01, 0x81, 0x02,
                         0x95, 0x01, 0x75, 0x05, 0x81, 0x01, 0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15,
                         0x81, 0x25, 0x7f, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xc0, 0xc0};

TEST(DescriptorParser, ReadsTheMouseOfTheSpecification) {
  const auto mouse = parsed(k_boot_mouse);
  ASSERT_EQ(mouse.fields.size(), 3u);
  EXPECT_FALSE(mouse.has_report_ids);
  EXPECT_EQ(mouse.report_length(ReportType::input, 0), 3u);
  EXPECT_EQ(mouse.collections.size(), 2u);
  EXPECT_EQ(mouse.collections[1].parent, 0);
  EXPECT_EQ(mouse.enclosing(mouse.fields[2], k_collection_application), k_mouse);
  EXPECT_EQ(mouse.enclosing(mouse.fields[2], k_collection_physical), k_pointer);
  EXPECT_TRUE(mouse.fields[1].is_constant());
  const Field& motion = mouse.fields[2];
  EXPECT_EQ(motion.bit_offset, 8u);
  EXPECT_EQ(motion.logical_minimum, -127);
  const Bytes report{0x05, 0x81, 0x7f};
  EXPECT_EQ(value_of(motion, report, 0), -127);
  EXPECT_EQ(value_of(motion, report, 1), 127);
  EXPECT_EQ(value_of(mouse.fields[0], report, 2), 1);
  EXPECT_EQ(mouse.fields[0].usage_of(2), usage(k_page_button, 3));
}

TEST(DescriptorParser, ReportIdsShiftEveryFieldByAByteAndCountSeparately) {
  const auto found = parsed({0x05, 0x01, 0x09, 0x02, 0xa1, 0x01, 0x75, 0x08, 0x95, 0x01, 0x85, 0x02, 0x09, 0x30, 0x81,
                             0x02, 0x85, 0x05, 0x09, 0x31, 0x81, 0x02, 0x85, 0x02, 0x09, 0x32, 0x81, 0x02, 0xc0});
  ASSERT_EQ(found.fields.size(), 3u);
  EXPECT_EQ(found.fields[0].bit_offset, 8u);
  EXPECT_EQ(found.fields[1].bit_offset, 8u);
  EXPECT_EQ(found.fields[2].bit_offset, 16u);
  EXPECT_EQ(found.report_length(ReportType::input, 2), 3u);
  EXPECT_EQ(found.report_length(ReportType::input, 5), 2u);
  EXPECT_EQ(found.longest_report(ReportType::input), 3u);
  EXPECT_EQ(found.longest_report(ReportType::output), 0u);
}

TEST(DescriptorParser, PushAndPopKeepAllGlobals) {
  const auto found =
      parsed({0x05, 0x01, 0x15, 0x05, 0x25, 0x09, 0x75, 0x04, 0x95, 0x02, 0x65, 0x11, 0x55, 0x0e, 0xa4, 0x05, 0x0d,
              0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x08, 0x65, 0x00, 0x55, 0x00, 0xb4, 0x09, 0x30, 0x81, 0x02});
  ASSERT_EQ(found.fields.size(), 1u);
  const Field& field = found.fields[0];
  EXPECT_EQ(field.usage_of(0), k_x);
  EXPECT_EQ(field.logical_minimum, 5);
  EXPECT_EQ(field.logical_maximum, 9);
  EXPECT_EQ(field.bit_size, 4u);
  EXPECT_EQ(field.count, 2u);
  EXPECT_EQ(field.unit, 0x11u);
  EXPECT_EQ(field.unit_exponent, -2);
}

TEST(DescriptorParser, TheSignOfAMaximumFollowsFromItsMinimum) {
  const auto unsigned_range = parsed({0x15, 0x00, 0x25, 0xff, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02});
  EXPECT_EQ(unsigned_range.fields[0].logical_maximum, 255);
  EXPECT_FALSE(unsigned_range.fields[0].is_signed());
  // The maximum may stand before the minimum.
  const auto signed_range = parsed({0x25, 0xff, 0x15, 0x80, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02});
  EXPECT_EQ(signed_range.fields[0].logical_minimum, -128);
  EXPECT_EQ(signed_range.fields[0].logical_maximum, -1);
  const auto wide = parsed({0x15, 0x00, 0x27, 0xff, 0xff, 0xff, 0xff, 0x75, 0x20, 0x95, 0x01, 0x81, 0x02});
  EXPECT_EQ(wide.fields[0].logical_maximum, 4294967295);
}

TEST(DescriptorParser, AnUndefinedPhysicalRangeIsTheLogicalOne) {
  const auto found = parsed({0x15, 0x00, 0x25, 0x7f, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x45, 0x0a, 0x81, 0x02});
  EXPECT_EQ(found.fields[0].physical_maximum, 127);
  EXPECT_EQ(found.fields[1].physical_maximum, 10);
}

TEST(DescriptorParser, UsagesTakeThePageInForceAtTheMainItem) {
  const auto found =
      parsed({0x05, 0x09, 0x09, 0x30, 0x05, 0x01, 0x75, 0x08, 0x95, 0x02, 0x0b, 0x30, 0x00, 0x0d, 0x00, 0x81, 0x02});
  EXPECT_EQ(found.fields[0].usage_of(0), k_x);
  EXPECT_EQ(found.fields[0].usage_of(1), k_tip_pressure);
}

TEST(DescriptorParser, ExtendedRangesKeepTheirPage) {
  const auto found = parsed({0x05, 0x01, 0x1b, 0x01, 0x00, 0x09, 0x00, 0x29, 0x04, 0x75, 0x01, 0x95, 0x04, 0x81, 0x02});
  EXPECT_EQ(found.fields[0].usage_of(3), usage(k_page_button, 4));
}

TEST(DescriptorParser, DelimitersOfferAlternatives) {
  const auto found = parsed(
      {0x05, 0x01, 0x75, 0x08, 0x95, 0x02, 0xa9, 0x01, 0x09, 0x30, 0x09, 0x32, 0xa9, 0x00, 0x09, 0x31, 0x81, 0x02});
  ASSERT_EQ(found.fields[0].usages.size(), 3u);
  EXPECT_TRUE(found.fields[0].usages[1].alternative);
  EXPECT_EQ(found.fields[0].usage_of(0), k_x);
  EXPECT_EQ(found.fields[0].usage_of(1), k_y);
}

TEST(DescriptorParser, DesignatorsStringsAndLongItems) {
  const auto found = parsed({0xfe, 0x03, 0xf0, 1,    2,    3,    0x39, 0x04, 0x49, 0x01, 0x59, 0x03, 0x79,
                             0x07, 0x89, 0x02, 0x99, 0x05, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x81, 0x02});
  ASSERT_EQ(found.fields.size(), 2u);
  ASSERT_EQ(found.fields[0].designators.size(), 2u);
  EXPECT_EQ(found.fields[0].designators[1].maximum, 3u);
  ASSERT_EQ(found.fields[0].strings.size(), 2u);
  EXPECT_EQ(found.fields[0].strings[0].minimum, 7u);
  EXPECT_TRUE(found.fields[1].designators.empty()) << "local items end with their main item";
}

TEST(DescriptorParser, ArraysFeaturesAndOutputs) {
  const auto keys = parsed({0x05, 0x07, 0x19, 0x00, 0x29, 0x65, 0x15, 0x00, 0x25, 0x65, 0x75, 0x08, 0x95,
                            0x06, 0x81, 0x00, 0x75, 0x01, 0x95, 0x03, 0x91, 0x02, 0x95, 0x10, 0xb1, 0x02});
  EXPECT_TRUE(keys.fields[0].is_array());
  EXPECT_EQ(keys.fields[0].usage_of(0x65), usage(7, 0x65));
  EXPECT_EQ(keys.report_length(ReportType::output, 0), 1u);
  EXPECT_EQ(keys.report_length(ReportType::feature, 0), 2u);
}

TEST(DescriptorParser, HugeUsageRangesCostNothing) {
  Bytes bytes{0x06, 0x00, 0xff, 0x75, 0x01, 0x95, 0x01};
  while (bytes.size() + 8 <= 65536) {
    bytes.insert(bytes.end(), {0x1a, 0x00, 0x00, 0x2a, 0xff, 0xff, 0x81, 0x02});
  }
  const auto found = parsed(bytes);
  EXPECT_EQ(found.fields.size(), (65536u - 7) / 8);
  EXPECT_EQ(found.fields.back().usage_count(), 65536u);
}

TEST(DescriptorParser, AcceptsTheDeepestNesting) {
  Bytes bytes;
  for (int i = 0; i < 16384; ++i) bytes.insert(bytes.end(), {0xa1, 0x02});
  for (int i = 0; i < 16384; ++i) bytes.push_back(0xc0);
  EXPECT_EQ(parsed(bytes).collections.size(), 16384u);
}

TEST(DescriptorParser, AnEmptyDescriptorIsLegal) { EXPECT_TRUE(parsed({}).fields.empty()); }

TEST(DescriptorParser, IllegalDescriptorsNameTheByte) {
  EXPECT_EQ(place_of_error({0x05}), "byte 0");
  EXPECT_EQ(place_of_error({0x05, 0x01, 0x26, 0xff}), "byte 2");
  EXPECT_EQ(place_of_error({0xfe, 0x05, 0x00, 1, 2}), "byte 0");
  EXPECT_EQ(place_of_error({0x05, 0x01, 0xc0}), "byte 2");
  EXPECT_EQ(place_of_error({0xa1, 0x01}), "byte 2");
  EXPECT_EQ(place_of_error({0xb4}), "byte 0");
  EXPECT_EQ(place_of_error({0x85, 0x00}), "byte 0");
  EXPECT_EQ(place_of_error({0x86, 0x00, 0x01}), "byte 0");
  EXPECT_EQ(place_of_error({0x15, 0x05, 0x25, 0x04, 0x81, 0x02}), "byte 4");
  EXPECT_EQ(place_of_error({0x19, 0x05, 0x29, 0x04}), "byte 2");
  EXPECT_EQ(place_of_error({0x19, 0x05, 0x81, 0x02}), "byte 0");
  EXPECT_EQ(place_of_error({0xa9, 0x01, 0x81, 0x02}), "byte 2");
  EXPECT_EQ(place_of_error({0xa9, 0x01, 0x09, 0x01}), "byte 0");
  EXPECT_EQ(place_of_error({0xa9, 0x00}), "byte 0");
  EXPECT_EQ(place_of_error({0xa9, 0x01, 0xa9, 0x01}), "byte 2");
  EXPECT_EQ(place_of_error({0x76, 0xff, 0xff, 0x96, 0xff, 0xff, 0x81, 0x02}), "byte 6");
  EXPECT_EQ(place_of_error({0x0c}), "byte 0");
  EXPECT_EQ(place_of_error({0xd0}), "byte 0");
  EXPECT_EQ(place_of_error(Bytes(65537, 0xa4)), "byte 65536");
}

TEST(DescriptorParser, TheTolerantReadingStepsOverReservedItems) {
  const auto found = parsed({0x0c, 0xd0, 0x19, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02}, Strictness::tolerant);
  EXPECT_EQ(found.fields.size(), 1u);
  EXPECT_FALSE(parse_report_descriptor(Bytes{0xc0}, Strictness::tolerant).ok());
}

}  // namespace
}  // namespace penpose::hid
