#include "firmware_io/decode/layout/layout_reader.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

base::Error error_of(const char* text) {
  const auto tree = parse_json(text);
  EXPECT_TRUE(tree.ok()) << text;
  base::Error error;
  if (tree.ok()) (void)read_protocols(JsonPlace(*tree, error));
  return error;
}

TEST(LayoutReader, LikeSkipIncludeAndUse) {
  const auto tree = parse_json(R"({
    "layouts": {"pen": {"gives": "pen", "x": "2 3", "y": "4 5"}},
    "rule_lists": {"both": [{"when": "0=01", "use": "pen"}, {"when": "0=02", "gives": "leave"}]},
    "protocols": {
      "one": {"shortest": 2, "tip_above": 7, "rules": [{"include": "both"}, {"gives": "pad", "keys": "1"}]},
      "two": {"like": "one", "skip": 1}}})");
  ASSERT_TRUE(tree.ok());
  base::Error error;
  const auto protocols = read_protocols(JsonPlace(*tree, error));
  ASSERT_EQ(error.what, "");
  const auto& two = *protocols.at("two");
  EXPECT_EQ(two.name, "two");
  EXPECT_EQ(two.skip, 1U);
  EXPECT_EQ(two.shortest, 2U);
  EXPECT_EQ(two.tip_above, 7);
  ASSERT_EQ(two.rules.size(), 3U);
  EXPECT_EQ(two.rules[0].layout->shortest, 6U);
  EXPECT_EQ(two.rules[0].layout->gives, Gives::pen);
  EXPECT_EQ(two.rules[1].layout->gives, Gives::leave);
  EXPECT_EQ(two.rules[2].layout->shortest, 2U);
}

TEST(LayoutReader, ErrorsPointAtTheMember) {
  EXPECT_EQ(error_of(R"({"protocols": {"p": {}}})").place, "/protocols/p");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"rules": [{"gives": "pen", "x": "2 q"}]}}})").place,
            "/protocols/p/rules/0/x");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"rules": [{"gives": "pen", "X": "2"}]}}})").place,
            "/protocols/p/rules/0/X");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"rules": [{"gives": "pencil"}]}}})").place, "/protocols/p/rules/0/gives");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"rules": [{"when": "1.9", "gives": "pad"}]}}})").place,
            "/protocols/p/rules/0/when");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"rules": [{"use": "none"}]}}})").place, "/protocols/p/rules/0/use");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"rules": [{"include": "none"}]}}})").place,
            "/protocols/p/rules/0/include");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"like": "q"}, "q": {"rules": [{"gives": "pad"}]}}})").place,
            "/protocols/p/like");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"skip": 65, "rules": [{"gives": "pad"}]}}})").place, "/protocols/p/skip");
  EXPECT_EQ(error_of(R"({"layouts": {"l": {"when": "1.0", "gives": "pad"}}})").place, "/layouts/l/when");
  EXPECT_EQ(error_of(R"({"protocols": {"p": {"rules": [{"gives": "pad", "dial": {"left": "1.0"}}]}}})").place,
            "/protocols/p/rules/0/dial/left");
  EXPECT_EQ(
      error_of(
          R"({"protocols": {"p": {"rules": [{"gives": "pad", "key_codes": {"from": 2, "modifiers": 1, "keys": ["xx"]}}]}}})")
          .place,
      "/protocols/p/rules/0/key_codes/keys/0");
}

}  // namespace
}  // namespace penpose::decode
