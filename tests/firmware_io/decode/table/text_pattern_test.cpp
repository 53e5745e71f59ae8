#include "firmware_io/decode/table/text_pattern.h"

#include <chrono>
#include <gtest/gtest.h>
#include <initializer_list>
#include <string_view>

namespace penpose::decode {
namespace {

bool found(std::string_view pattern, std::string_view text) {
  const auto parsed = TextPattern::parse(pattern);
  EXPECT_TRUE(parsed.ok()) << pattern << ": " << (parsed.ok() ? "" : parsed.error().what);
  return parsed.ok() && parsed->found_in(text);
}

struct Search {
  std::string_view pattern, text;
  bool found;
};

void check(std::initializer_list<Search> searches) {
  for (const Search& one : searches)
    EXPECT_EQ(found(one.pattern, one.text), one.found) << one.pattern << ", " << one.text;
}

TEST(TextPattern, SearchesUnlessAnchored) {
  check({
      {"Huion", "HuionH690", true},
      {"H690", "HuionH690", true},
      {"^H690", "HuionH690", false},
      {"Huion$", "HuionH690", false},
      {"^$", "", true},
      {"^$", "x", false},
      {"", "anything", true},
  });
}

TEST(TextPattern, FirmwareNames) {
  constexpr const char* k_pattern = R"(HUION_T(176|18a|21c)_\d{6}$)";
  check({
      {k_pattern, "HUION_T18a_190523", true},
      {k_pattern, "HUION_T18b_190523", false},
      {k_pattern, "HUION_T18a_19052", false},
      {k_pattern, "HUION_T18a_1905231x", false},
      {R"((?:M20h|M19f)_\d{2,4}$)", "M19f_123", true},
      {R"((?:M20h|M19f)_\d{2,4}$)", "M19f_1", false},
  });
}

TEST(TextPattern, LookAhead) {
  constexpr const char* k_pattern = R"(^(?!(2020-10-23_Release3|2023-08-07_Release\.)$).*$)";
  check({
      {k_pattern, "2020-10-23_Release3", false},
      {k_pattern, "2023-08-07_Release.", false},
      {k_pattern, "2023-08-07_Release", true},
      {k_pattern, "2020-10-23_Release33", true},
      {"a(?=b)", "xab", true},
      {"a(?=b)", "xac", false},
  });
}

TEST(TextPattern, ZeroBytesAndClasses) {
  check({
      {R"(^HA60\x00*$)", std::string_view("HA60\0\0\0", 7), true},
      {R"(^\x00*420\x00*$)",
       std::string_view("\0\0"
                        "420",
                        5),
       true},
      {R"(^HA60\x00*$)", std::string_view("HA60\0x", 6), false},
      {"^[a-c_]+[^0-9]$", "ab_x", true},
      {"^[a-c_]+[^0-9]$", "ab_1", false},
      {R"(^[\d-]+$)", "20-09-08", true},
      {R"(\w\s\W)", "a -", true},
  });
}

TEST(TextPattern, Quantifiers) {
  check({
      {"^a?b*c+$", "ccc", true},
      {"^a?b*c+$", "abbc", true},
      {"^a?b*c+$", "ab", false},
      {"^(ab|cd){2}$", "abcd", true},
      {"^(ab|cd){2}$", "ab", false},
      {"^a{2,}$", "aaaa", true},
      {"^a{2,}$", "a", false},
      {"^a{,2}$", "a{,2}", true},
      {"^(a*)*b$", "aab", true},
  });
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
