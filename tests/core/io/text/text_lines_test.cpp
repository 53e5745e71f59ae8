#include "core/io/text/text_lines.h"

#include <gtest/gtest.h>

namespace penpose::io {
namespace {

TEST(TextLines, TakesAnyLineEnd) {
  TextLines lines("a\nb\r\nc\rd\n\ne");
  for (const char* want : {"a", "b", "c", "d", "", "e"}) EXPECT_EQ(lines.next(), want);
  EXPECT_EQ(lines.number(), 6U);
  EXPECT_FALSE(lines.next());
  EXPECT_EQ(lines.error("what", "remedy").place, "line 6");
}

TEST(TextLines, SkipsCommentsAndBlankLines) {
  TextLines lines("# all of it\n\n  \t\n 1 2 # three\n");
  EXPECT_EQ(lines.next_content(), "1 2");
  EXPECT_EQ(lines.number(), 4U);
  EXPECT_FALSE(lines.next_content());
}

TEST(TextLines, WordsAndCoordinates) {
  std::string_view line = "  v\t1.5 ";
  EXPECT_EQ(take_word(line), "v");
  EXPECT_EQ(parse_coordinate(take_word(line)), 1.5);
  EXPECT_EQ(take_word(line), "");
  EXPECT_FALSE(parse_coordinate("nan"));
  EXPECT_FALSE(parse_coordinate("inf"));
  EXPECT_FALSE(parse_coordinate("1e39"));
  EXPECT_FALSE(parse_coordinate("1,5"));
  EXPECT_FALSE(parse_coordinate(""));
}

}  // namespace
}  // namespace penpose::io
