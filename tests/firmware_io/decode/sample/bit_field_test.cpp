#include "firmware_io/decode/sample/bit_field.h"

#include <array>
#include <gtest/gtest.h>
#include <string>

namespace penpose::decode {
namespace {

constexpr std::array<std::uint8_t, 10> k_report{0x02, 0xe1, 0x12, 0x34, 0x80, 0xff, 0x7f, 0x40, 0xc5, 0x03};

std::int64_t read(const char* text) {
  const auto number = BitNumber::parse(text);
  EXPECT_TRUE(number.ok()) << text;
  return number.ok() ? number->read_or(k_report, -1000) : -1;
}
bool holds(const char* text, base::Bytes report = k_report) {
  const auto test = BitTest::parse(text);
  EXPECT_TRUE(test.ok()) << text;
  return test.ok() && test->holds(report);
}

TEST(BitNumber, JoinsRunsLowestFirst) {
  EXPECT_EQ(read("2"), 0x12);
  EXPECT_EQ(read("2 3"), 0x3412);
  EXPECT_EQ(read("2 3 4"), 0x803412);
  EXPECT_EQ(read("9.1 3 2"), 0x12 << 9 | 0x34 << 1 | 1);
  EXPECT_EQ(read("8.4-7 2"), 0x12c);
  EXPECT_EQ(read("8.0-3 _4 2"), 0x1205);
  EXPECT_EQ(read("5 5 5 5"), 0xffffffff);
}

TEST(BitNumber, BytesThatAreNoNeighboursInOrderAreJoinedAllTheSame) {
  EXPECT_EQ(read("3 2"), 0x1234);
  EXPECT_EQ(read("2 4"), 0x8012);
  EXPECT_EQ(read("2 | 3"), 0x36);
  EXPECT_EQ(read("2 _8 3"), 0x340012);
  EXPECT_EQ(read("2 !3"), 0xcb12);
  EXPECT_EQ(read("2 3.0-6"), 0x3412);
  EXPECT_EQ(read("_8 2"), 0x1200);
  // Zero bits alone ask for no byte of the report.
  EXPECT_EQ(BitNumber::parse("_4")->read_or({}, -1), 0);
}

TEST(BitNumber, InvertsTestsAndOrs) {
  EXPECT_EQ(read("!7.6"), 0);
  EXPECT_EQ(read("!7"), 0xbf);
  EXPECT_EQ(read("0=02/10 0=03 3!=00"), 0b101);
  EXPECT_EQ(read("2 _1 | _8 9.0"), 0x112);
}

TEST(BitNumber, SignNegationOffsetAndCondition) {
  EXPECT_EQ(read("4 signed"), -128);
  EXPECT_EQ(read("4 signed negated"), 128);
  EXPECT_EQ(read("7.0-6 signed"), -64);
  EXPECT_EQ(read("6 minus 64"), 63);
  EXPECT_EQ(read("6 negated plus 1"), -126);
  EXPECT_EQ(read("2 if 1.0"), 0x12);
  EXPECT_EQ(read("2 if 1.1"), -1000);
  EXPECT_EQ(read("2 signed minus 1 if 1.0 0=02"), 0x11);
}

TEST(BitNumber, SaysHowLongAReportMustBe) {
  EXPECT_EQ(BitNumber::parse("2 3")->reach(), 4U);
  EXPECT_EQ(BitNumber::parse("2 if 6.1")->reach(), 7U);
  const auto optional = BitNumber::parse("8 if length>=9");
  EXPECT_EQ(optional->reach(), 0U);
  EXPECT_EQ(optional->read_or(base::Bytes(k_report).first(8), -1), -1);
  EXPECT_EQ(optional->read_or(base::Bytes(k_report).first(9), -1), 0xc5);
  // A stated length that does not cover the number must not make it safe.
  EXPECT_EQ(BitNumber::parse("8 if length>=5")->reach(), 9U);
}

TEST(BitTest, EachForm) {
  for (const char* test : {"", "1.0", "!1.1", "0=02", "0=10/02", "1&f0=e0", "1&f0!=a0", "length>=10"})
    EXPECT_TRUE(holds(test)) << test;
  for (const char* test : {"1.1", "0=10/03", "0!=02", "length>=11", "1.0 0=03"}) EXPECT_FALSE(holds(test)) << test;
}

TEST(BitTest, ComparesWithUpToFourValuesWhateverTheByteIs) {
  const auto one = BitTest::parse("0&f7=00/80/41/ff");
  const auto none = BitTest::parse("0!=00/01/80");
  const auto two = BitTest::parse("0=7f/fe");
  ASSERT_TRUE(one && none && two);
  for (int value = 0; value < 256; ++value) {
    const std::uint8_t report[] = {static_cast<std::uint8_t>(value)};
    const int masked = value & 0xf7;
    EXPECT_EQ(one->holds(report), masked == 0x00 || masked == 0x80 || masked == 0x41) << value;
    EXPECT_EQ(none->holds(report), value != 0x00 && value != 0x01 && value != 0x80) << value;
    EXPECT_EQ(two->holds(report), value == 0x7f || value == 0xfe) << value;
  }
}

TEST(BitTest, FailsWhereTheReportEnds) {
  EXPECT_FALSE(holds("3=34", base::Bytes(k_report).first(3)));
  EXPECT_FALSE(holds("!3.0", base::Bytes(k_report).first(3)));
  EXPECT_FALSE(holds("3!=99", {}));
}

TEST(BitFieldErrors, NameTheWord) {
  for (const auto* text :
       {"x", "1.8", "1.", "1.5-3", "5000", "0=", "0=xyz", "1&=4", "0=1/2/3/4/5", "length>=", "1.0-3", "="}) {
    const auto test = BitTest::parse(text);
    ASSERT_FALSE(test.ok()) << text;
    EXPECT_NE(test.error().what.find(text), std::string::npos) << test.error().what;
  }
  for (const auto* text : {"", "signed", "2 signed signed", "2 if", "2 plus", "2 minus x", "1.0-9", "5 5 5 5 5", "_33",
                           "2 unknown", "-1", "99999999999999999999"}) {
    EXPECT_FALSE(BitNumber::parse(text).ok()) << text;
  }
  EXPECT_FALSE(BitNumber::parse(std::string(1000, '1')).ok());
}

}  // namespace
}  // namespace penpose::decode
