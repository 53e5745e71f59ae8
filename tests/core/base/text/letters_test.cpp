#include "core/base/text/letters.h"

#include <gtest/gtest.h>

namespace penpose::base {
namespace {

TEST(Letters, HaveCaseInAsciiAlone) {
  EXPECT_EQ(lower_case("Brow.AZ az_[{\xc3\x84"), "brow.az az_[{\xc3\x84");
  EXPECT_EQ(upper('z'), 'Z');
  EXPECT_EQ(upper('{'), '{');
  EXPECT_TRUE(same_but_case("eyeBlink_L", "EYEblink_l"));
  EXPECT_FALSE(same_but_case("eyeBlink", "eyeBlink_L"));
  EXPECT_FALSE(same_but_case("[", "{"));
}

TEST(Letters, HexadecimalDigits) {
  EXPECT_EQ(hex_value('0'), 0U);
  EXPECT_EQ(hex_value('9'), 9U);
  EXPECT_EQ(hex_value('a'), 10U);
  EXPECT_EQ(hex_value('F'), 15U);
  for (const char c : {'g', 'G', '/', ':', '@', '`', ' '}) EXPECT_FALSE(hex_value(c).has_value()) << c;
  std::string text;
  append_hex(text, 0xfeed, 2);
  append_hex(text, 0xfeed, 8, HexCase::upper);
  append_hex(text, ~std::uint64_t{0}, 16);
  EXPECT_EQ(text, "ed0000FEEDffffffffffffffff");
}

TEST(Letters, TheMarkIsTakenOnceAndAtTheBeginning) {
  EXPECT_EQ(without_mark("\xef\xbb\xbf\xef\xbb\xbf{"), "\xef\xbb\xbf{");
  EXPECT_EQ(without_mark("a\xef\xbb\xbf"), "a\xef\xbb\xbf");
  EXPECT_EQ(without_mark(""), "");
}

}  // namespace
}  // namespace penpose::base
