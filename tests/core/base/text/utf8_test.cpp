#include "core/base/text/utf8.h"

#include <gtest/gtest.h>

namespace penpose::base {
namespace {

TEST(Utf8, WhatIsInvalidIsReplaced) {
  EXPECT_EQ(valid_utf8("Auge \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"), "Auge \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80");
  EXPECT_EQ(valid_utf8("\xe9ye"), "?ye");
  EXPECT_EQ(valid_utf8("\xc0\x80\xed\xa0\x80\xf5"), "??????");
  EXPECT_EQ(valid_utf8("x\xe2\x82"), "x??");
}

}  // namespace
}  // namespace penpose::base
