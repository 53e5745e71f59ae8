#include "core/base/json/json.h"

#include <gtest/gtest.h>

namespace penpose::json {
namespace {

TEST(Json, SaysWhereTheTextStopsBeingJson) {
  const auto broken = parse_json(base::as_bytes("{\"a\": 1,, }"));
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().place, "byte offset 8");
  EXPECT_FALSE(parse_json({}).ok());
  EXPECT_FALSE(parse_json(base::as_bytes("[1e999]")).ok());
  EXPECT_FALSE(parse_json(base::as_bytes("[\"\xff\"]")).ok());
}

TEST(Json, RefusesDeepNestingBeforeItIsParsed) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  const auto result = parse_json(base::as_bytes(deep));
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().place, "byte offset 64");
  const std::string allowed = std::string(64, '[') + std::string(64, ']');
  EXPECT_TRUE(parse_json(base::as_bytes(allowed)).ok());
  EXPECT_TRUE(parse_json(base::as_bytes("\"" + std::string(100, '[') + "\"")).ok());
}

TEST(Json, WholeNumbersKeepTheirBounds) {
  EXPECT_EQ(whole_number(Json(3.0), 0, 5), 3);
  EXPECT_EQ(whole_number(Json(-2), -5, 5), -2);
  EXPECT_FALSE(whole_number(Json(3.5), 0, 5));
  EXPECT_FALSE(whole_number(Json(6), 0, 5));
  EXPECT_FALSE(whole_number(Json(-1), 0, 5));
  EXPECT_FALSE(whole_number(Json(18446744073709551615ULL), 0, 5));
  EXPECT_FALSE(whole_number(Json(1e300), 0, 5));
  EXPECT_FALSE(whole_number(Json("3"), 0, 5));
}

TEST(Json, PointersEscapeTheirPieces) { EXPECT_EQ(child(child("/a", 3), "x/y~z"), "/a/3/x~1y~0z"); }

}  // namespace
}  // namespace penpose::json
