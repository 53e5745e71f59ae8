#include "core/json/json_value.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

// The peer is nlohmann's value, whose members ours means the same by.

namespace penpose::json {
namespace {

TEST(JsonValue, TextsAreReadAndWrittenAsByThePeer) {
  for (const char* text : {"null",
                           "true",
                           "[]",
                           "{}",
                           "[[],{},[{}]]",
                           "-0",
                           "-0.0",
                           "0",
                           "18446744073709551615",
                           "18446744073709551616",
                           "-9223372036854775808",
                           "1e300",
                           "0.1",
                           "1e-7",
                           "123456789012345680.0",
                           "2.0",
                           "5e-324",
                           "\"\"",
                           R"("quote \" slash \\ line \n tab \t bell \u0007 del \u007f é \ud83d\ude00")",
                           R"({"b":1,"a":[1,2.5,"x",null,false]})",
                           R"({"twice":[1,2],"other":0,"twice":{"second":true}})",
                           R"({"":{"deep":[{"deeper":[[1],[2,[3]]]}]}})"}) {
    const auto peer = nlohmann::json::parse(text);
    const Json ours = Json::parse(text);
    EXPECT_EQ(ours.dump(), peer.dump()) << text;
    EXPECT_EQ(ours.dump(2), peer.dump(2)) << text;
    EXPECT_EQ(ours.size(), peer.size()) << text;
    EXPECT_EQ(ours.is_number_integer(), peer.is_number_integer()) << text;
    EXPECT_EQ(ours.is_number_unsigned(), peer.is_number_unsigned()) << text;
    EXPECT_TRUE(Json::parse(ours.dump()) == ours) << text;
  }
}

TEST(JsonValue, WhatIsNoTextIsReplacedAndWhatIsNoNumberIsNull) {
  for (const std::string text : {"\xff", "a\xc3", "\xed\xa0\x80z", "ok\xf0\x9f\x98"}) {
    EXPECT_EQ(Json(text).dump(), nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  EXPECT_EQ(Json(std::nan("")).dump(), "null");
  EXPECT_EQ(Json(-std::numeric_limits<double>::infinity()).dump(), "null");
}

TEST(JsonValue, BracesMeanWhatTheyMeanToThePeer) {
  const Json ours = {{"list", {1, 2.5, "x"}}, {"object", {{"a", 1}, {"b", {{"c", nullptr}}}}}, {"pairs", {1, {2, 3}}}};
  const nlohmann::json peer = {
      {"list", {1, 2.5, "x"}}, {"object", {{"a", 1}, {"b", {{"c", nullptr}}}}}, {"pairs", {1, {2, 3}}}};
  EXPECT_EQ(ours.dump(), peer.dump());
  EXPECT_EQ(Json::array({{"a", 1}}).dump(), nlohmann::json::array({{"a", 1}}).dump());
  EXPECT_EQ(Json::array({{{"a", 1}}}).dump(), nlohmann::json::array({{{"a", 1}}}).dump());
}

TEST(JsonValue, WhatIsNoJsonSaysWhere) {
  for (const char* text : {"", "[1,,2]", "{\"a\":}", "[1", "nul", "\"\x01\"", "[1] 2"}) {
    std::size_t peer = 0;
    try {
      [[maybe_unused]] const auto none = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
      peer = error.byte;
    }
    try {
      static_cast<void>(Json::parse(text));
      ADD_FAILURE() << text;
    } catch (const Json::parse_error& error) {
      EXPECT_EQ(error.byte, peer) << text;
      EXPECT_FALSE(error.too_large) << text;
    }
  }
  try {
    static_cast<void>(Json::parse("[1e999]"));
    ADD_FAILURE();
  } catch (const Json::parse_error& error) {
    EXPECT_TRUE(error.too_large);
  }
}

TEST(JsonValue, NumbersAreEqualByTheirValue) {
  EXPECT_TRUE(Json(3) == Json(3U));
  EXPECT_TRUE(Json(3) == Json(3.0));
  EXPECT_FALSE(Json(-1) == Json(18446744073709551615ULL));
  EXPECT_FALSE(Json(1) == Json(true));
  EXPECT_FALSE(Json("1") == Json(1));
}

TEST(JsonValue, MembersAreMadeWhereTheyAreNamed) {
  Json value;
  value["a"]["b"] = 1;
  value["list"].push_back(2);
  EXPECT_EQ(value.dump(), R"({"a":{"b":1},"list":[2]})");
  const Json copy = value;
  value["a"] = "changed";
  EXPECT_EQ(copy["a"]["b"], 1) << "a copy is its own";
  EXPECT_THROW(static_cast<void>(copy.at("none")), std::out_of_range);
  EXPECT_THROW(static_cast<void>(copy["list"].get<double>()), Json::type_error);
  EXPECT_TRUE(copy.find("none") == copy.end());
}

}  // namespace
}  // namespace penpose::json
