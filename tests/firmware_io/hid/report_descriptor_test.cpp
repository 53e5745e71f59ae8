#include "firmware_io/hid/report_descriptor.h"

#include <gtest/gtest.h>

namespace penpose::hid {
namespace {

TEST(ReportDescriptor, TellsWhichCollectionsAreAroundAField) {
  ReportDescriptor descriptor;
  descriptor.collections = {{k_collection_application, k_pen, -1},
                            {k_collection_physical, k_stylus, 0},
                            {k_collection_logical, k_finger, -1}};
  Field field;
  field.collection = 1;
  EXPECT_EQ(descriptor.enclosing(field, k_collection_physical), k_stylus);
  EXPECT_EQ(descriptor.enclosing(field, k_collection_application), k_pen);
  EXPECT_EQ(descriptor.enclosing(field, k_collection_logical), 0u);
  EXPECT_TRUE(descriptor.is_inside(field, k_pen));
  EXPECT_FALSE(descriptor.is_inside(field, k_finger));
  field.collection = -1;
  EXPECT_EQ(descriptor.enclosing(field, k_collection_application), 0u);
}

TEST(ReportDescriptor, ReportLengthsRoundUpToBytes) {
  ReportDescriptor descriptor;
  descriptor.report_bits[0][3] = 9;
  EXPECT_EQ(descriptor.report_length(ReportType::input, 3), 2u);
  descriptor.has_report_ids = true;
  EXPECT_EQ(descriptor.report_length(ReportType::input, 3), 3u);
  EXPECT_EQ(descriptor.report_length(ReportType::input, 4), 0u);
  EXPECT_EQ(descriptor.longest_report(ReportType::input), 3u);
}

}  // namespace
}  // namespace penpose::hid
