#include "core/base/numbers.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace penpose::base {
namespace {

TEST(Numbers, ReadsAWholeTextOrNothing) {
  EXPECT_EQ(parse_double("1.5"), 1.5);
  EXPECT_EQ(parse_double("+1.5"), 1.5);
  EXPECT_EQ(parse_double("-.5e-3"), -0.0005);
  EXPECT_EQ(parse_double("1E2"), 100.0);
  for (const char* bad : {"", " ", "1.5 ", " 1.5", "1,5", "1.5x", "0x10", "--1", "+-1", "++1", "+", "-", ".", "e5",
                          "1e", "1e999", "one"}) {
    EXPECT_FALSE(parse_double(bad)) << '"' << bad << '"';
  }
  EXPECT_TRUE(std::isinf(*parse_double("inf")));
  EXPECT_TRUE(std::isnan(*parse_double("nan")));
}

TEST(Numbers, TakesMicrosoftsNamesOfWhatIsNoNumber) {
  for (const char* text : {"1.#QNAN", "-1.#IND", "1.#SNAN", "-1.#IND00", "1.#QNAN0e+000", "1.#R", "-1.#IO"}) {
    ASSERT_TRUE(parse_double(text)) << text;
    EXPECT_TRUE(std::isnan(*parse_double(text))) << text;
  }
  EXPECT_EQ(parse_double("1.#INF"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_double("-1.#INF00"), -std::numeric_limits<double>::infinity());
  for (const char* text : {"1.#", "1.#5", "2.#INF", "1.#INF1", "--1.#INF", "1.#INFe+x", "1.#inf x"})
    EXPECT_FALSE(parse_double(text)) << text;
}

TEST(Numbers, ReadsIntegersOfABase) {
  EXPECT_EQ(parse_int("-42"), -42);
  EXPECT_EQ(parse_int("+42"), 42);
  EXPECT_EQ(parse_int("ff", 16), 255);
  EXPECT_EQ(parse_int("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_FALSE(parse_int("9223372036854775808"));
  EXPECT_FALSE(parse_int("1.0"));
  EXPECT_FALSE(parse_int("1_000"));
  EXPECT_FALSE(parse_int(""));
  EXPECT_EQ(parse_uint("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_FALSE(parse_uint("18446744073709551616"));
  EXPECT_FALSE(parse_uint("-1"));
  EXPECT_FALSE(parse_uint("g", 16));
}

TEST(Numbers, WritesTheShortestTextThatReadsBackEqual) {
  EXPECT_EQ(format_double(0.1), "0.1");
  EXPECT_EQ(format_double(-3), "-3");
  EXPECT_EQ(format_float(0.1F), "0.1");
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    const auto d = std::bit_cast<double>(random());
    if (std::isnan(d)) continue;
    EXPECT_EQ(parse_double(format_double(d)), d);
    const auto f = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isnan(f)) continue;
    EXPECT_EQ(static_cast<float>(*parse_double(format_float(f))), f);
  }
}

TEST(Numbers, WritesFixedDigitsForPeople) {
  EXPECT_EQ(format_fixed(3.14159, 2), "3.14");
  EXPECT_EQ(format_fixed(2, 3), "2.000");
  EXPECT_EQ(format_fixed(-0.5, 0), "-0");
  EXPECT_EQ(format_fixed(1e300, 2).size(), 304U);
}

TEST(Numbers, TrimsBlanks) {
  EXPECT_EQ(trim(" \t a b\t\r"), "a b");
  EXPECT_EQ(trim("x"), "x");
  for (const char* nothing : {" \t ", ""}) EXPECT_EQ(trim(nothing), "");
}

}  // namespace
}  // namespace penpose::base
