#include "core/base/result.h"

#include <gtest/gtest.h>
#include <memory>

namespace penpose::base {
namespace {

TEST(Result, HoldsAValueOrAnError) {
  const Result<int> good = 7;
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(good.value(), 7);
  EXPECT_EQ(*good, 7);

  const Result<int> bad = Error{"is empty", "line 3", "add a line"};
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().what, "is empty");
  EXPECT_EQ(bad.error().place, "line 3");
  EXPECT_EQ(bad.error().remedy, "add a line");
}

TEST(Result, GivesAwayWhatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>> made = std::make_unique<int>(5);
  const std::unique_ptr<int> taken = std::move(made).value();
  EXPECT_EQ(*taken, 5);
}

TEST(ResultDeathTest, AViolatedPreconditionEndsTheProgram) {
  const Result<int> bad = Error{"x", "", ""};
  EXPECT_DEATH((void)bad.value(), "");
  const Result<int> good = 1;
  EXPECT_DEATH((void)good.error(), "");
}

TEST(Error, IsOneLineOfFilePlaceWhatAndRemedy) {
  const Error error{"the vertex does not exist", "/cases/2", "use vertices of this model"};
  EXPECT_EQ(error.line("a.json"), "a.json: /cases/2: the vertex does not exist; use vertices of this model");
  EXPECT_EQ(error.line(), "/cases/2: the vertex does not exist; use vertices of this model");
}

TEST(Error, LeavesOutEmptyPieces) {
  EXPECT_EQ((Error{"is empty", "", ""}.line("a.obj")), "a.obj: is empty");
  EXPECT_EQ((Error{"is empty", "", "add a line"}.line()), "is empty; add a line");
  EXPECT_EQ((Error{"is empty", "line 1", ""}.line()), "line 1: is empty");
}

TEST(Error, StaysOneLineWhateverAFilePutIntoIt) {
  const std::string line = Error{"bad\nname", "mesh \x1b[31mred\r", "fix\tit\x7f"}.line("a\nb.glb");
  for (const char c : line) {
    EXPECT_GE(static_cast<unsigned char>(c), 0x20);
    EXPECT_NE(c, 0x7f);
  }
  EXPECT_NE(line.find("bad name"), std::string::npos);
}

}  // namespace
}  // namespace penpose::base
