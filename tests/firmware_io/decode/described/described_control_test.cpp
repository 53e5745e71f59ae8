#include "firmware_io/decode/described/described_control.h"

#include <gtest/gtest.h>

#include "tests/support/hands/hand_descriptors.h"

namespace penpose::decode {
namespace {

TEST(DescribedControl, IsReadWhereItsFieldStands) {
  const auto parsed = hid::parse_report_descriptor(tests::touch_descriptor(1));
  ASSERT_TRUE(parsed.ok());
  const auto report = tests::touch_report({{0b100, 9, 1234, 4321}}, 1);
  const hid::Field& flags = parsed->fields[0];
  EXPECT_EQ(DescribedControl(flags, 0).value(report), 0);
  EXPECT_EQ(DescribedControl(flags, 2).value(report), 1);
  const DescribedControl x(parsed->fields[3], 0);
  EXPECT_EQ(x.value(report), 1234);
  EXPECT_TRUE(x.holds(9600));
  EXPECT_FALSE(x.holds(9601));
}

TEST(DescribedControl, FieldsComeReportByReportWithoutPadding) {
  tests::Report items{0x05, 0x0d, 0x09, 0x04, 0xa1, 0x01};
  for (const std::uint8_t id : {std::uint8_t{2}, std::uint8_t{1}, std::uint8_t{2}}) {
    tests::append(items, {0x85, id});
    tests::append(items, tests::input({0xd0042}, 1, 1));
    tests::append(items, tests::padding(7));
  }
  items.push_back(0xc0);
  const auto parsed = hid::parse_report_descriptor(items);
  ASSERT_TRUE(parsed.ok());
  const auto fields = fields_by_report(*parsed, hid::ReportType::input);
  ASSERT_EQ(fields.size(), 3u);
  EXPECT_EQ(fields[0]->report_id, 2);
  EXPECT_EQ(fields[1]->report_id, 2);
  EXPECT_EQ(fields[2]->report_id, 1);
  EXPECT_TRUE(fields_by_report(*parsed, hid::ReportType::feature).empty());
}

}  // namespace
}  // namespace penpose::decode
