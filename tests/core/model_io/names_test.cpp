#include "core/model_io/names.h"

#include <gtest/gtest.h>

namespace penpose::model_io {
namespace {

TEST(Names, RepeatedOnesGetNumbersThatAreFree) {
  std::vector<std::string> names = {"eye", "eye", "eye.2", "", "", "eye"};
  make_unique(names);
  EXPECT_EQ(names, (std::vector<std::string>{"eye", "eye.3", "eye.2", "", ".2", "eye.4"}));
  auto again = names;
  make_unique(again);
  EXPECT_EQ(again, names);
}

TEST(Names, InvalidUtf8IsReplaced) {
  EXPECT_EQ(valid_utf8("Auge \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"), "Auge \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80");
  EXPECT_EQ(valid_utf8("\xe9ye"), "?ye");
  EXPECT_EQ(valid_utf8("\xc0\x80\xed\xa0\x80\xf5"), "??????");
  EXPECT_EQ(valid_utf8("x\xe2\x82"), "x??");
}

}  // namespace
}  // namespace penpose::model_io
