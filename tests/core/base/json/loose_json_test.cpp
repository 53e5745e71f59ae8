#include "core/base/json/loose_json.h"

#include <gtest/gtest.h>

namespace penpose::json {
namespace {

std::string read(const char* text) {
  const auto json = parse_loose_json(base::as_bytes(std::string_view(text)));
  return json ? json->dump() : json.error().place;
}

TEST(LooseJson, WhatIsNoNumberIsNull) {
  EXPECT_EQ(read("[NaN, Infinity, -Infinity, -nan, inf, 1e999, -1E+999, 1e5]"),
            "[null,null,null,null,null,null,null,100000.0]");
  EXPECT_EQ(read(R"({"NaN": "a \" NaN \\", "x":NaN})"), R"({"NaN":"a \" NaN \\","x":null})");
  EXPECT_EQ(read("[1, true, null]"), "[1,true,null]");
  EXPECT_EQ(read("NaN"), "null");
  EXPECT_EQ(read("[NaN, 1e-999]"), "[null,0.0]");
  EXPECT_EQ(read("[NaN, 1.2.3e5]"), "byte offset 9");
}

TEST(LooseJson, ErrorsAreWhereTheFileHasThem) {
  EXPECT_EQ(read("[NaN, NaN, x]"), "byte offset 11");
  EXPECT_EQ(read("[1, x]"), "byte offset 4");
  EXPECT_EQ(read("[-Infinity, x]"), "byte offset 12");
  EXPECT_EQ(read("[\"NaN"), read("[\"abc"));
  EXPECT_EQ(read("[Nanny]"), "byte offset 1");
  EXPECT_EQ(read("\"\\"), read("\"\\"));
}

}  // namespace
}  // namespace penpose::json
