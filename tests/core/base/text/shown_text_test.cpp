#include "core/base/text/shown_text.h"

#include <gtest/gtest.h>

#include "core/base/result.h"
#include "core/base/text/utf8.h"

namespace penpose::base {
namespace {

TEST(ShownText, OrdinaryNamesStayAsTheyAre) {
  for (const char* name : {"", "jawOpen", "a b", "Z\xc3\xa4hne", "\xe5\x8f\xa3", "\xf0\x9f\x98\x80", "C:\\face"}) {
    EXPECT_EQ(shown_name(name), name);
  }
}

TEST(ShownText, NothingThatMovesATerminalOrHidesGetsThrough) {
  EXPECT_EQ(shown_name("\x1b[2J\a"), "\\x1b[2J\\x07");
  EXPECT_EQ(shown_name(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(shown_name("two\nlines\r"), "two\\x0alines\\x0d");
  EXPECT_EQ(shown_name("\x7f"), "\\x7f");
  EXPECT_EQ(shown_name("\xc2\x9b"
                       "31m"),
            "\\u{9b}31m")
      << "ESC [ in one character";
  EXPECT_EQ(shown_name("\xe2\x80\xae"
                       "gnp.exe"),
            "\\u{202e}gnp.exe")
      << "turns the direction of what follows";
  EXPECT_EQ(shown_name("a\xe2\x80\x8b"), "a\\u{200b}");
  EXPECT_EQ(shown_name("\xff\xc3"), "\\xff\\xc3") << "no UTF-8";
}

// Every pair of bytes, in every place of a name.
TEST(ShownText, WhateverComesWhatIsShownIsPlainText) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const std::string name{'x', static_cast<char>(a), static_cast<char>(b), 'y'};
      const std::string shown = shown_name(name);
      ASSERT_EQ(valid_utf8(shown), shown);
      for (const char c : shown) ASSERT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << a << ' ' << b;
      ASSERT_TRUE(shown.starts_with('x'));
    }
  }
}

TEST(ShownText, LongNamesLoseTheirMiddle) {
  const std::string name = "begin" + std::string(1000000, '-') + "end";
  const std::string shown = shown_name(name);
  EXPECT_LE(shown.size(), 120U);
  EXPECT_TRUE(shown.starts_with("begin---"));
  EXPECT_TRUE(shown.ends_with("---end"));
  EXPECT_NE(shown.find("..."), std::string::npos);
  std::string wide;
  for (int i = 0; i < 500; ++i) wide += "\xe5\x8f\xa3";
  EXPECT_EQ(valid_utf8(shown_name(wide)), shown_name(wide)) << "no character is cut";
  EXPECT_EQ(shown_name(std::string(120, 'n')), std::string(120, 'n'));
}

TEST(ShownText, AnErrorIsOneLineOfPlainText) {
  const Error error{"the name \"\x1b]0;x\a\" is\ntaken", "/a\x1b", std::string(100000, 'r')};
  const std::string line = error.line("f\x1b[1m");
  for (const char c : line) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20);
  EXPECT_LT(line.size(), 10000U);
  EXPECT_TRUE(line.starts_with("f\\x1b[1m: /a\\x1b: the name \"\\x1b]0;x\\x07\" is taken; rrr")) << line.substr(0, 90);
  // A place is made of names that a file gave.
  const std::string cut = Error{"is unknown", "/" + std::string(70000, ' ') + "end", "remove it"}.line("f");
  EXPECT_LT(cut.size(), 600U);
  EXPECT_TRUE(cut.ends_with("end: is unknown; remove it")) << cut;
}

}  // namespace
}  // namespace penpose::base
