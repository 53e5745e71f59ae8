#include "firmware_io/hid/field.h"

#include <array>
#include <gtest/gtest.h>

namespace penpose::hid {
namespace {

TEST(Extract, TakesBitsFromAnyOffset) {
  const std::array<std::uint8_t, 10> report{0x01, 0x23, 0x45, 0x67, 0x89, 0xab, 0xcd, 0xef, 0x10, 0x32};
  EXPECT_EQ(extract_unsigned(report, 0, 8), 0x01u);
  EXPECT_EQ(extract_unsigned(report, 4, 8), 0x30u);
  EXPECT_EQ(extract_unsigned(report, 8, 16), 0x4523u);
  EXPECT_EQ(extract_unsigned(report, 12, 12), 0x452u);
  EXPECT_EQ(extract_unsigned(report, 8, 64), 0x10efcdab89674523u);
  EXPECT_EQ(extract_unsigned(report, 12, 64), 0x210efcdab8967452u);
  EXPECT_EQ(extract_unsigned(report, 3, 0), 0u);
}

TEST(Extract, BitsPastTheEndAreZero) {
  const std::array<std::uint8_t, 2> report{0xff, 0xff};
  EXPECT_EQ(extract_unsigned(report, 8, 16), 0x00ffu);
  EXPECT_EQ(extract_unsigned(report, 16, 32), 0u);
  EXPECT_EQ(extract_unsigned(report, std::uint64_t{1} << 40, 32), 0u);
  EXPECT_EQ(extract_unsigned({}, 0, 64), 0u);
}

TEST(Extract, SignedValuesFillUpFromTheirSign) {
  const std::array<std::uint8_t, 4> report{0x80, 0xff, 0x7f, 0x0f};
  EXPECT_EQ(extract_signed(report, 0, 8), -128);
  EXPECT_EQ(extract_signed(report, 8, 8), -1);
  EXPECT_EQ(extract_signed(report, 8, 16), 0x7fff);
  EXPECT_EQ(extract_signed(report, 24, 4), -1);
  EXPECT_EQ(extract_signed(report, 24, 5), 15);
}

TEST(Field, RepeatsItsLastUsageForFurtherControls) {
  Field field;
  field.flags = k_flag_variable;
  field.usages = {{usage(9, 1), usage(9, 3), false}, {usage(1, 0x30), usage(1, 0x30), false}};
  EXPECT_EQ(field.usage_of(0), usage(9, 1));
  EXPECT_EQ(field.usage_of(2), usage(9, 3));
  EXPECT_EQ(field.usage_of(3), k_x);
  EXPECT_EQ(field.usage_of(100), k_x);
  EXPECT_EQ(field.usage_count(), 4u);
}

TEST(Field, ArraySelectorsBeyondTheListMeanNothing) {
  Field field;
  field.usages = {{usage(7, 4), usage(7, 6), false}};
  EXPECT_EQ(field.usage_of(2), usage(7, 6));
  EXPECT_EQ(field.usage_of(3), 0u);
}

TEST(Field, AlternativesOfADelimitedSetTakeUpNoControl) {
  Field field;
  field.flags = k_flag_variable;
  field.usages = {{k_x, k_x, false}, {k_z, k_z, true}, {k_y, k_y, false}};
  EXPECT_EQ(field.usage_of(1), k_y);
  EXPECT_EQ(field.usage_count(), 2u);
}

TEST(Units, CentimetresInchesAndDegrees) {
  Field field;
  field.logical_maximum = 20000;
  field.physical_maximum = 2000;
  field.unit = 0x11;
  field.unit_exponent = -2;  // 20 cm
  EXPECT_DOUBLE_EQ(units_per_mm(field), 100);
  field.unit = 0x13;
  field.unit_exponent = -3;  // 2 inches
  EXPECT_DOUBLE_EQ(units_per_mm(field), 20000 / 50.8);
  EXPECT_EQ(units_per_degree(field), 0);
  field.unit = 0x14;
  field.unit_exponent = 0;
  EXPECT_DOUBLE_EQ(units_per_degree(field), 10);
  EXPECT_EQ(units_per_mm(field), 0);
  field.unit = 0x12;  // radians
  field.physical_maximum = 2;
  EXPECT_NEAR(units_per_degree(field), 174.53, 0.01);
}

TEST(Units, UnknownOrEmptyRangesGiveZero) {
  Field field;
  field.logical_maximum = 100;
  field.physical_maximum = 100;
  EXPECT_EQ(units_per_mm(field), 0);
  field.unit = 0x11;
  field.physical_maximum = 0;
  EXPECT_EQ(units_per_mm(field), 0);
  field.unit = 0x21;  // an area
  field.physical_maximum = 10;
  EXPECT_EQ(units_per_mm(field), 0);
}

}  // namespace
}  // namespace penpose::hid
