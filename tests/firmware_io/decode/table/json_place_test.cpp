#include "firmware_io/decode/table/json_place.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

TEST(JsonPlace, MembersKeepTheirOrder) {
  const auto json = parse_json(R"({"b": 1, "c": null, "a": {}})");
  ASSERT_TRUE(json.ok());
  base::Error error;
  std::string names;
  for (const auto& [name, place] : JsonPlace(*json, error).members()) names += name + place.pointer();
  EXPECT_EQ(names, "b/bc/ca/a");
}

TEST(JsonPlace, ErrorsNameTheByte) {
  for (const auto* text : {"", "{", "[1,]", "{\"a\" 1}", "nul", "\"\xff\"", "1e999", "[1] 2"}) {
    const auto json = parse_json(text);
    ASSERT_FALSE(json.ok()) << text;
    EXPECT_EQ(json.error().place.rfind("byte ", 0), 0U) << json.error().place;
  }
}

TEST(JsonPlace, DeepNestingIsRefusedNotFollowed) {
  EXPECT_FALSE(parse_json(std::string(1'000'000, '[')).ok());
  EXPECT_FALSE(parse_json(std::string(33, '[') + std::string(33, ']')).ok());
  EXPECT_TRUE(parse_json(std::string(32, '[') + std::string(32, ']')).ok());
}

TEST(JsonPlace, FirstErrorStaysWithItsPointer) {
  const auto json = parse_json(R"({"a": {"b/c": [1, "two", 3.5]}, "n": 7})");
  ASSERT_TRUE(json.ok());
  base::Error error;
  const JsonPlace root(*json, error);
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
  const auto json = parse_json(R"({"text": "t", "half": 0.5, "big": 1e300, "list": [], "yes": true})");
  ASSERT_TRUE(json.ok());
  const auto complains = [&](const auto& read) {
    base::Error error;
    read(JsonPlace(*json, error));
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
