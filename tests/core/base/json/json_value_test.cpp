#include "core/base/json/json_value.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

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
                           R"("quote \" slash \\ line \n tab \t bell \u0007 é \ud83d\ude00")",
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
      EXPECT_EQ(error.fault, Json::Fault::text) << text;
    }
  }
  try {
    static_cast<void>(Json::parse("[1e999]"));
    ADD_FAILURE();
  } catch (const Json::parse_error& error) {
    EXPECT_EQ(error.fault, Json::Fault::number);
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

TEST(JsonValue, TextIsAlwaysValid) {
  for (const std::string text : {"plain", "\"quoted\\\"", "line\nbreak\x01", "Größe", "\xff\xc3", "\xe0\x80\x80",
                                 "\xed\xa0\x80", "\xf0\x9f\x96\x8a", "\xf4\x90\x80\x80", "\xc3", "a\xe2\x82z"}) {
    const auto read = nlohmann::json::parse(Json(text).dump(), nullptr, false);
    EXPECT_FALSE(read.is_discarded()) << text;
    EXPECT_EQ(read.dump(), nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
}

TEST(JsonValue, WhatSteersATerminalIsEscapedAndStaysWhatItWas) {
  const std::string text =
      "a\x1b[2J\x7f\xc2\x9b"
      "31m \xc2\xa0";
  EXPECT_EQ(Json(text).dump(), "\"a\\u001b[2J\\u007f\\u009b31m \xc2\xa0\"");
  EXPECT_EQ(nlohmann::json::parse(Json(text).dump()), text);
}

TEST(JsonValue, NumbersAreWrittenAsByThePeerAndReadToTheSameBits) {
  std::uint64_t state = 1;
  const auto next = [&] { return state = state * 6364136223846793005u + 1442695040888963407u; };
  int shorter = 0;
  for (int i = 0; i < 20000; ++i) {
    double value = std::bit_cast<double>(next());
    if (!std::isfinite(value)) continue;
    if (i % 2 == 0) value = static_cast<double>(static_cast<std::int64_t>(next()) >> (i % 60)) / 1024.0;
    const std::string ours = Json(value).dump();
    const std::string peers = nlohmann::json(value).dump();
    EXPECT_EQ(std::bit_cast<std::uint64_t>(nlohmann::json::parse(ours).get<double>()),
              std::bit_cast<std::uint64_t>(value));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(Json::parse(peers).get<double>()), std::bit_cast<std::uint64_t>(value));
    // The peer's digits are now and then one more than it takes, or not the nearest of as many.
    if (ours != peers) ++shorter;
    EXPECT_LE(ours.size(), peers.size());
  }
  EXPECT_LT(shorter, 400);
}

TEST(JsonValue, BrokenTextsAreRefusedWhereThePeerRefusesThem) {
  const std::string seed =
      R"([{"a":[1,-2.5e+3,true,null,"x\u00e9\ud83d\ude00\n"],"b":{"c":[],"d":false}},"é€😀",1e5, 0.25])";
  constexpr std::string_view k_put = "[]{}:,\"\\ue0-+.19 \t\x01\xc3\xe2\x82\xff\x80n";
  std::uint64_t state = 7;
  const auto next = [&](std::size_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>(state >> 33) % below;
  };
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = seed;
    for (std::size_t change = next(3); change < 3 && !text.empty(); ++change) {
      const std::size_t at = next(text.size());
      switch (next(4)) {
        case 0:
          text.erase(at, 1 + next(3));
          break;
        case 1:
          text.insert(at, 1, k_put[next(k_put.size())]);
          break;
        case 2:
          text[at] = k_put[next(k_put.size())];
          break;
        default:
          text.resize(at + 1);
      }
    }
    std::optional<nlohmann::json> peer;
    std::size_t byte = 0;
    try {
      peer = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
      byte = error.byte;
    } catch (const nlohmann::json::out_of_range&) {
      byte = 0;
    }
    try {
      const Json ours = Json::parse(text);
      ASSERT_TRUE(peer) << text;
      EXPECT_EQ(nlohmann::json::parse(ours.dump()), *peer) << text;
    } catch (const Json::parse_error& error) {
      ++refused;
      ASSERT_FALSE(peer) << text;
      if (error.fault == Json::Fault::text) {
        EXPECT_EQ(error.byte, byte) << text;
      }
    }
  }
  EXPECT_GT(refused, 10000);
}

TEST(JsonValue, NestingIsBoundedWithoutRecursion) {
  const std::string deep = std::string(1'000'000, '[');
  try {
    static_cast<void>(Json::parse(deep, 32));
    ADD_FAILURE();
  } catch (const Json::parse_error& error) {
    EXPECT_EQ(error.fault, Json::Fault::depth);
    EXPECT_EQ(error.byte, 33U);
  }
  EXPECT_TRUE(Json::parse("[[[]]]", 3).is_array());
}

TEST(JsonValue, MembersAreWrittenInTheOrderInWhichTheyWereMadeWhereAskedFor) {
  Json value = {{"z", 1}, {"a", {{"y", 2}, {"b", 3}}}};
  value["m"] = 4;
  value["z"] = 5;
  EXPECT_EQ(value.dump_as_made(), R"({"z":5,"a":{"y":2,"b":3},"m":4})");
  EXPECT_EQ(Json::parse(value.dump_as_made()).dump_as_made(), value.dump_as_made());
  const Json copy = value;
  EXPECT_EQ(copy.dump_as_made(), value.dump_as_made());
  EXPECT_EQ(value.dump(), R"({"a":{"b":3,"y":2},"m":4,"z":5})");
}

TEST(JsonValue, NumbersOutOfRangeAreRefusedWhereTheyAreTooLargeAlone) {
  for (const char* text : {"1e-999", "0.0000001e-400", "0e999999999999999999999", "-0.0e5"}) {
    EXPECT_EQ(Json::parse(text).get<double>(), 0.0) << text;
  }
  for (const char* text : {"1e999", "-1e309", "0.001e9999999999999999999999", "1000e308"}) {
    EXPECT_THROW(static_cast<void>(Json::parse(text)), Json::parse_error) << text;
  }
  EXPECT_THROW(static_cast<void>(Json::parse(std::string(400, '9'))), Json::parse_error);
}

TEST(JsonValue, AByteOrderMarkAndZerosAtTheEndAreTaken) {
  EXPECT_EQ(Json::parse("\xef\xbb\xbf[1]").size(), 1U);
  EXPECT_EQ(Json::parse(std::string_view("[1] \0\0", 6)).size(), 1U);
  EXPECT_THROW(static_cast<void>(Json::parse("\xef\xbb[1]")), Json::parse_error);
}

}  // namespace
}  // namespace penpose::json
