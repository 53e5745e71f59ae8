#include "core/io/text/names.h"

#include <gtest/gtest.h>

namespace penpose::io {
namespace {

TEST(Names, RepeatedOnesGetNumbersThatAreFree) {
  std::vector<std::string> names = {"eye", "eye", "eye.2", "", "", "eye"};
  make_unique(names);
  EXPECT_EQ(names, (std::vector<std::string>{"eye", "eye.3", "eye.2", "", ".2", "eye.4"}));
  auto again = names;
  make_unique(again);
  EXPECT_EQ(again, names);
}

}  // namespace
}  // namespace penpose::io
