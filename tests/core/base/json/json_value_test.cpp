#include "core/base/json/json_value.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <optional>

// The peer is nlohmann's value as it comes, with its own reader and writer.

namespace penpose::json {
namespace {

using Peer = nlohmann::json;

std::optional<Json> read(std::string_view text, Refused* why = nullptr) {
  Json value;
  const auto refused = read_json(text, k_max_json_depth, value);
  if (refused && why != nullptr) *why = *refused;
  return refused ? std::nullopt : std::optional(value);
}

Refused::Why why_refused(std::string_view text) {
  Refused refused{};
  EXPECT_FALSE(read(text, &refused)) << text;
  return refused.why;
}

std::string valid_dump(const std::string& text) {
  return Peer(text).dump(-1, ' ', false, Peer::error_handler_t::replace);
}

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
    const auto peer = Peer::parse(text);
    const auto ours = read(text);
    ASSERT_TRUE(ours) << text;
    EXPECT_EQ(dump(*ours), peer.dump()) << text;
    EXPECT_EQ(dump(*ours, 2), peer.dump(2)) << text;
    EXPECT_EQ(ours->type(), peer.type()) << text;
    EXPECT_TRUE(read(dump(*ours)) == ours) << text;
  }
}

TEST(JsonValue, WhatIsNoTextIsReplacedAndWhatIsNoNumberIsNull) {
  for (const std::string text : {"\xff", "a\xc3", "\xed\xa0\x80z", "ok\xf0\x9f\x98"}) {
    EXPECT_EQ(dump(text), valid_dump(text));
  }
  EXPECT_EQ(dump(std::nan("")), "null");
  EXPECT_EQ(dump(-std::numeric_limits<double>::infinity()), "null");
}

TEST(JsonValue, WhatIsNoJsonSaysWhere) {
  for (const char* text : {"", "[1,,2]", "{\"a\":}", "[1", "nul", "\"\x01\"", "[1] 2"}) {
    std::size_t peer = 0;
    try {
      [[maybe_unused]] const auto none = Peer::parse(text);
    } catch (const Peer::parse_error& error) {
      peer = error.byte;
    }
    Refused refused{};
    EXPECT_FALSE(read(text, &refused)) << text;
    EXPECT_EQ(refused.offset + 1, peer) << text;
    EXPECT_EQ(refused.why, Refused::Why::text) << text;
  }
  EXPECT_EQ(why_refused("[1e999]"), Refused::Why::number);
}

TEST(JsonValue, WhatIsAskedForAndNotThereIsAnError) {
  Json value;
  value["a"]["b"] = 1;
  value["list"].push_back(2);
  EXPECT_EQ(dump(value), R"({"a":{"b":1},"list":[2]})");
  const Json copy = value;
  value["a"] = "changed";
  EXPECT_EQ(copy["a"]["b"], 1) << "a copy is its own";
  EXPECT_THROW(static_cast<void>(copy["none"]), std::out_of_range);
  EXPECT_THROW(static_cast<void>(copy["list"][1]), std::out_of_range);
  EXPECT_THROW(static_cast<void>(copy["list"].get<double>()), Json::type_error);
  EXPECT_TRUE(copy.find("none") == copy.end());
}

TEST(JsonValue, TextIsAlwaysValid) {
  for (const std::string text : {"plain", "\"quoted\\\"", "line\nbreak\x01", "Größe", "\xff\xc3", "\xe0\x80\x80",
                                 "\xed\xa0\x80", "\xf0\x9f\x96\x8a", "\xf4\x90\x80\x80", "\xc3", "a\xe2\x82z"}) {
    const auto again = Peer::parse(dump(text), nullptr, false);
    EXPECT_FALSE(again.is_discarded()) << text;
    EXPECT_EQ(again.dump(), valid_dump(text));
  }
}

TEST(JsonValue, WhatSteersATerminalIsEscapedAndStaysWhatItWas) {
  const std::string text =
      "a\x1b[2J\x7f\xc2\x9b"
      "31m \xc2\xa0";
  EXPECT_EQ(dump(text), "\"a\\u001b[2J\\u007f\\u009b31m \xc2\xa0\"");
  EXPECT_EQ(Peer::parse(dump(text)), text);
}

TEST(JsonValue, NumbersAreWrittenAsByThePeerAndReadToTheSameBits) {
  std::uint64_t state = 1;
  const auto next = [&] { return state = state * 6364136223846793005u + 1442695040888963407u; };
  int shorter = 0;
  for (int i = 0; i < 20000; ++i) {
    double value = std::bit_cast<double>(next());
    if (!std::isfinite(value)) continue;
    if (i % 2 == 0) value = static_cast<double>(static_cast<std::int64_t>(next()) >> (i % 60)) / 1024.0;
    const std::string ours = dump(value);
    const std::string peers = Peer(value).dump();
    EXPECT_EQ(std::bit_cast<std::uint64_t>(Peer::parse(ours).get<double>()), std::bit_cast<std::uint64_t>(value));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read(peers)->get<double>()), std::bit_cast<std::uint64_t>(value));
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
  int refusals = 0;
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
    std::optional<Peer> peer;
    std::size_t byte = 0;
    try {
      peer = Peer::parse(text);
    } catch (const Peer::parse_error& error) {
      byte = error.byte;
    } catch (const Peer::out_of_range&) {
      byte = 0;
    }
    Refused refused{};
    if (const auto ours = read(text, &refused)) {
      ASSERT_TRUE(peer) << text;
      EXPECT_EQ(Peer::parse(dump(*ours)), *peer) << text;
    } else {
      ++refusals;
      ASSERT_FALSE(peer) << text;
      if (refused.why == Refused::Why::text) {
        EXPECT_EQ(refused.offset + 1, byte) << text;
      }
    }
  }
  EXPECT_GT(refusals, 10000);
}

TEST(JsonValue, NestingIsBoundedWithoutRecursion) {
  Json value;
  const auto refused = read_json(R"({"]\"":")" + std::string("]]\",\"a\":") + std::string(1'000'000, '['), 32, value);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->why, Refused::Why::depth);
  EXPECT_EQ(refused->offset, 16U + 31U) << "brackets in texts are none";
  EXPECT_FALSE(read_json("[[[]]]", 3, value));
}

TEST(JsonValue, MembersAreWrittenInTheOrderInWhichTheyWereMadeWhereAskedFor) {
  Json value = {{"z", 1}, {"a", {{"y", 2}, {"b", 3}}}};
  value["m"] = 4;
  value["z"] = 5;
  value.update({{"c", 6}, {"a", 7}});
  EXPECT_EQ(dump_as_made(value), R"({"z":5,"a":7,"m":4,"c":6})");
  EXPECT_EQ(dump_as_made(*read(dump_as_made(value))), dump_as_made(value));
  const Json copy = value;
  EXPECT_EQ(dump_as_made(copy), dump_as_made(value));
  EXPECT_EQ(dump(value), R"({"a":7,"c":6,"m":4,"z":5})");
}

TEST(JsonValue, NumbersOutOfRangeAreRefusedWhereTheyAreTooLargeAlone) {
  for (const char* text : {"1e-999", "0.0000001e-400", "0e999999999999999999999", "-0.0e5"}) {
    EXPECT_EQ(read(text)->get<double>(), 0.0) << text;
  }
  for (const char* text : {"1e999", "-1e309", "0.001e9999999999999999999999", "1000e308"}) {
    EXPECT_EQ(why_refused(text), Refused::Why::number) << text;
  }
  EXPECT_EQ(why_refused(std::string(400, '9')), Refused::Why::number);
}

TEST(JsonValue, AByteOrderMarkAndZerosAtTheEndAreTaken) {
  EXPECT_EQ(read("\xef\xbb\xbf[1]")->size(), 1U);
  EXPECT_EQ(read(std::string_view("[1] \0\0", 6))->size(), 1U);
  EXPECT_EQ(why_refused("\xef\xbb[1]"), Refused::Why::text);
}

}  // namespace
}  // namespace penpose::json
