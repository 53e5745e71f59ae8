#include "ui/cli/number_range.h"

#include <gtest/gtest.h>

namespace penpose::cli {
namespace {

TEST(NumberRange, TakesFiniteNumbersWithin) {
  const auto check = number_range(0.5, 60);
  for (std::string text : {"0.5", "60", "1e1", "+3"}) EXPECT_EQ(check(text), "") << text;
  for (std::string text : {"nan", "inf", "-inf", "0.4", "61", "1,5", "x", ""}) {
    EXPECT_EQ(check(text), "write a number from 0.5 to 60, not \"" + text + "\"");
  }
}

}  // namespace
}  // namespace penpose::cli
