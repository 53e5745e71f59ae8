#include "firmware_io/decode/table/text_pattern.h"

#include <chrono>
#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

bool found(std::string_view pattern, std::string_view text) {
  const auto parsed = TextPattern::parse(pattern);
  EXPECT_TRUE(parsed.ok()) << pattern << ": " << (parsed.ok() ? "" : parsed.error().what);
  return parsed.ok() && parsed->found_in(text);
}

TEST(TextPattern, SearchesUnlessAnchored) {
  EXPECT_TRUE(found("Huion", "HuionH690"));
  EXPECT_TRUE(found("H690", "HuionH690"));
  EXPECT_FALSE(found("^H690", "HuionH690"));
  EXPECT_FALSE(found("Huion$", "HuionH690"));
  EXPECT_TRUE(found("^$", ""));
  EXPECT_FALSE(found("^$", "x"));
  EXPECT_TRUE(found("", "anything"));
}

TEST(TextPattern, FirmwareNames) {
  const auto* const pattern = R"(HUION_T(176|18a|21c)_\d{6}$)";
  EXPECT_TRUE(found(pattern, "HUION_T18a_190523"));
  EXPECT_FALSE(found(pattern, "HUION_T18b_190523"));
  EXPECT_FALSE(found(pattern, "HUION_T18a_19052"));
  EXPECT_FALSE(found(pattern, "HUION_T18a_1905231x"));
  EXPECT_TRUE(found(R"((?:M20h|M19f)_\d{2,4}$)", "M19f_123"));
  EXPECT_FALSE(found(R"((?:M20h|M19f)_\d{2,4}$)", "M19f_1"));
}

TEST(TextPattern, LookAhead) {
  const auto* const pattern = R"(^(?!(2020-10-23_Release3|2023-08-07_Release\.)$).*$)";
  EXPECT_FALSE(found(pattern, "2020-10-23_Release3"));
  EXPECT_FALSE(found(pattern, "2023-08-07_Release."));
  EXPECT_TRUE(found(pattern, "2023-08-07_Release"));
  EXPECT_TRUE(found(pattern, "2020-10-23_Release33"));
  EXPECT_TRUE(found("a(?=b)", "xab"));
  EXPECT_FALSE(found("a(?=b)", "xac"));
}

TEST(TextPattern, ZeroBytesAndClasses) {
  EXPECT_TRUE(found(R"(^HA60\x00*$)", std::string_view("HA60\0\0\0", 7)));
  EXPECT_TRUE(found(R"(^\x00*420\x00*$)", std::string_view("\0\0"
                                                           "420",
                                                           5)));
  EXPECT_FALSE(found(R"(^HA60\x00*$)", std::string_view("HA60\0x", 6)));
  EXPECT_TRUE(found("^[a-c_]+[^0-9]$", "ab_x"));
  EXPECT_FALSE(found("^[a-c_]+[^0-9]$", "ab_1"));
  EXPECT_TRUE(found(R"(^[\d-]+$)", "20-09-08"));
  EXPECT_TRUE(found(R"(\w\s\W)", "a -"));
}

TEST(TextPattern, Quantifiers) {
  EXPECT_TRUE(found("^a?b*c+$", "ccc"));
  EXPECT_TRUE(found("^a?b*c+$", "abbc"));
  EXPECT_FALSE(found("^a?b*c+$", "ab"));
  EXPECT_TRUE(found("^(ab|cd){2}$", "abcd"));
  EXPECT_FALSE(found("^(ab|cd){2}$", "ab"));
  EXPECT_TRUE(found("^a{2,}$", "aaaa"));
  EXPECT_FALSE(found("^a{2,}$", "a"));
  EXPECT_TRUE(found("^a{,2}$", "a{,2}"));
  EXPECT_TRUE(found("^(a*)*b$", "aab"));
}

TEST(TextPattern, RefusesWhatItDoesNotKnow) {
  for (const auto* pattern : {"(", ")", "a)", "[a", "*", "a**", "(?<=a)b", "(?i)a", R"(\1)", "\\", R"(\xg0)", "a{300}",
                              "a{3,2}", "[a-\\d]", "((((((((((((((((((a))))))))))))))))))", "((a{200}){200}){200}"}) {
    const auto parsed = TextPattern::parse(pattern);
    ASSERT_FALSE(parsed.ok()) << pattern;
    EXPECT_FALSE(parsed.error().remedy.empty());
  }
  EXPECT_FALSE(TextPattern::parse(std::string(513, 'a')).ok());
}

TEST(TextPattern, HostilePatternsEndSoon) {
  const std::string text(255, 'a');
  const auto begin = std::chrono::steady_clock::now();
  for (const auto* pattern : {"^(a|a)*b", "^(a*)*b", "(a?){100}a{100}b", "(?=(?=(?=a*b)a*b)a*b)x", "((a*)*(a*)*)*b"}) {
    EXPECT_FALSE(found(pattern, text)) << pattern;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

}  // namespace
}  // namespace penpose::decode
