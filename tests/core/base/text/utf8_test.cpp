#include "core/base/text/utf8.h"

#include <gtest/gtest.h>
#include <utility>

namespace penpose::base {
namespace {

TEST(Utf8, WhatIsInvalidIsReplaced) {
  EXPECT_EQ(valid_utf8("Auge \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"), "Auge \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80");
  const std::pair<const char*, const char*> mended[] = {
      {"\xe9ye", "?ye"}, {"\xc0\x80\xed\xa0\x80\xf5", "??????"}, {"x\xe2\x82", "x??"}};
  for (const auto& [text, wanted] : mended) EXPECT_EQ(valid_utf8(text), wanted);
}

}  // namespace
}  // namespace penpose::base
