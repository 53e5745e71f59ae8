#include "ui/demo/expression_file.h"

#include <gtest/gtest.h>

namespace penpose::demo {
namespace {

const std::string k_camera =
    R"("camera": {"eye": [0, 0, 2], "look_at": [0, 0, 0], "up": [0, 1, 0], "vertical_fov_degrees": 30})";

std::string with_expressions(const std::string& list) {
  return R"({"viewport": [640, 480], "expressions": [)" + list + "]}";
}

std::string smile(const std::string& reference = "[[1, 2], [3, 4]]") {
  return R"({"name": "smile", )" + k_camera + R"(, "curves": [{"reference": )" + reference +
         R"(, "target": [[1, 0], [3, 2.5], [5, 6]]}]})";
}

TEST(ExpressionFile, IsRead) {
  const auto file = read_expressions(with_expressions(smile()));
  ASSERT_TRUE(file.ok()) << file.error().line();
  EXPECT_EQ(file->viewport, (geometry::Viewport{640, 480}));
  ASSERT_EQ(file->expressions.size(), 1U);
  const Expression& expression = file->expressions[0];
  EXPECT_EQ(expression.name, "smile");
  EXPECT_EQ(expression.camera.eye, (geometry::ModelPoint{0, 0, 2}));
  ASSERT_EQ(expression.curves.size(), 1U);
  EXPECT_EQ(expression.curves[0].reference.size(), 2U);
  EXPECT_EQ(expression.curves[0].target[1], (curve::PxPoint{3, 2.5}));
}

TEST(ExpressionFile, FaultsNameTheirPlace) {
  const auto place = [](const std::string& text) {
    const auto file = read_expressions(text);
    return file.ok() ? "none" : file.error().place;
  };
  EXPECT_EQ(place(with_expressions(smile("[[1, 2]]"))), "/expressions/0/curves/0/reference");
  EXPECT_EQ(place(with_expressions(smile("[[1, 2], [3]]"))), "/expressions/0/curves/0/reference/1");
  EXPECT_EQ(place(with_expressions(smile(R"([[1, 2], [3, "x"]])"))), "/expressions/0/curves/0/reference/1/1");
  EXPECT_EQ(place(with_expressions(smile() + "," + smile())), "/expressions/1/name");
  EXPECT_EQ(place(with_expressions(R"({"name": "a"})")), "/expressions/0/camera");
  EXPECT_EQ(place(R"({"viewport": [0, 480], "expressions": []})"), "/viewport/0");
  EXPECT_EQ(place(R"({"viewport": [1, 1]})"), "/expressions");
  EXPECT_EQ(place("[]"), "/viewport");
}

TEST(ExpressionFile, WhatIsNoJsonIsRefused) {
  for (const std::string& text : {std::string(), std::string("{"), std::string("\xff\xfe"), std::string(100000, '[')}) {
    EXPECT_FALSE(read_expressions(text).ok());
  }
}

}  // namespace
}  // namespace penpose::demo
