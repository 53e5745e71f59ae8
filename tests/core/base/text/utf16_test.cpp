#include "core/base/text/utf16.h"

#include <gtest/gtest.h>

namespace penpose::base {
namespace {

struct Text {
  char32_t first;
  char32_t second;
  char32_t code;
};

TEST(Utf16, APairOfHalvesIsOneCodePoint) {
  for (const auto& [first, second, code] :
       {Text{0xd800, 0xdc00, 0x10000}, Text{0xd83d, 0xde00, 0x1f600}, Text{0xdbff, 0xdfff, 0x10ffff}}) {
    const Utf16Point point = utf16_point(first, second);
    EXPECT_EQ(point.code, code);
    EXPECT_EQ(point.units, 2U);
  }
}

TEST(Utf16, HalvesThatStandAloneAreReplacedAndLeaveWhatIsBehindThem) {
  for (const auto& [first, second, code] :
       {Text{0xd83d, 0, 0xfffd}, Text{0xd83d, U'x', 0xfffd}, Text{0xde00, 0xd83d, 0xfffd}, Text{0xd83d, 0xd83d, 0xfffd},
        Text{U'x', 0xde00, U'x'}, Text{0xffff, 0, 0xffff}}) {
    const Utf16Point point = utf16_point(first, second);
    EXPECT_EQ(point.code, code);
    EXPECT_EQ(point.units, 1U);
  }
}

}  // namespace
}  // namespace penpose::base
