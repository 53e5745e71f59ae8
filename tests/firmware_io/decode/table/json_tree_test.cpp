#include "firmware_io/decode/table/json_tree.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

TEST(JsonTree, KeepsValuesAndOrder) {
  const auto tree = parse_json(R"({"b": [1, -2.5, true, null, "x"], "a": {}})");
  ASSERT_TRUE(tree.ok());
  ASSERT_EQ(tree->members.size(), 2U);
  EXPECT_EQ(tree->members[0].first, "b");
  const auto& items = tree->members[0].second.items;
  ASSERT_EQ(items.size(), 5U);
  EXPECT_EQ(items[0].number, 1);
  EXPECT_EQ(items[1].number, -2.5);
  EXPECT_TRUE(items[2].boolean);
  EXPECT_EQ(items[3].kind, JsonValue::Kind::null);
  EXPECT_EQ(items[4].text, "x");
}

TEST(JsonTree, ManySiblingsKeepTheirChildren) {
  std::string text = "[";
  for (int i = 0; i < 1000; ++i) text += (i == 0 ? "{\"v\":[" : ",{\"v\":[") + std::to_string(i) + "]}";
  const auto tree = parse_json(text + "]");
  ASSERT_TRUE(tree.ok());
  ASSERT_EQ(tree->items.size(), 1000U);
  for (std::size_t i = 0; i < 1000; ++i) {
    ASSERT_EQ(tree->items[i].members[0].second.items[0].number, static_cast<double>(i));
  }
}

TEST(JsonTree, ErrorsNameTheByte) {
  for (const auto* text : {"", "{", "[1,]", "{\"a\" 1}", "nul", "\"\xff\"", "1e999", "[1] 2"}) {
    const auto tree = parse_json(text);
    ASSERT_FALSE(tree.ok()) << text;
    EXPECT_EQ(tree.error().place.rfind("byte ", 0), 0U) << tree.error().place;
  }
}

TEST(JsonTree, DeepNestingIsRefusedNotFollowed) {
  EXPECT_FALSE(parse_json(std::string(1'000'000, '[')).ok());
  EXPECT_FALSE(parse_json(std::string(33, '[') + std::string(33, ']')).ok());
  EXPECT_TRUE(parse_json(std::string(32, '[') + std::string(32, ']')).ok());
}

TEST(JsonPlace, FirstErrorStaysWithItsPointer) {
  const auto tree = parse_json(R"({"a": {"b/c": [1, "two", 3.5]}, "n": 7})");
  ASSERT_TRUE(tree.ok());
  base::Error error;
  const JsonPlace root(*tree, error);
  EXPECT_EQ(root.at("n").integer(0, 10), 7);
  EXPECT_TRUE(error.what.empty());
  const auto items = root.at("a").at("b/c").items();
  ASSERT_EQ(items.size(), 3U);
  (void)items[1].integer(0, 5);
  EXPECT_EQ(error.place, "/a/b~1c/1");
  (void)root.at("absent").text();
  EXPECT_EQ(error.place, "/a/b~1c/1");
}

TEST(JsonPlace, EachReadChecksItsKind) {
  const auto tree = parse_json(R"({"text": "t", "half": 0.5, "big": 1e300, "list": [], "yes": true})");
  ASSERT_TRUE(tree.ok());
  const auto complains = [&](const auto& read) {
    base::Error error;
    read(JsonPlace(*tree, error));
    return error.what;
  };
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("half").integer(0, 9); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("big").integer(0, 9); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("text").number(0, 9); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("text").text(0); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("list").text(); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("list").members(); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("text").items(); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("text").at("x"); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { (void)at.at("text").boolean(); }), "");
  EXPECT_NE(complains([](const JsonPlace& at) { at.allow_only({"text", "half", "big", "list"}); }), "");
  EXPECT_EQ(complains([](const JsonPlace& at) { at.allow_only({"text", "half", "big", "list", "yes"}); }), "");
  EXPECT_EQ(complains([](const JsonPlace& at) { (void)at.at("absent").items(); }), "");
}

}  // namespace
}  // namespace penpose::decode
