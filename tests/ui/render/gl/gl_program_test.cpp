#include "ui/render/gl/gl_program.h"

#include <gtest/gtest.h>

#include "ui/render/gl/offscreen_context.h"
#include "ui/render/gl/shaders.h"

namespace penpose::render {
namespace {

TEST(GlProgram, WhatTheDriverRefusesIsOneLine) {
  const auto context = OffscreenContext::make(DrawWay::gl);
  ASSERT_TRUE(context.ok());
  const GlDialect dialect = dialect_of_context(DrawWay::gl).value();
  EXPECT_TRUE(GlProgram::make(dialect, k_screen_vertex, k_background_fragment, {"corner"}).ok());
  const auto bad = GlProgram::make(dialect, k_screen_vertex, "void main() { nonsense }", {"corner"});
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().line().find('\n'), std::string::npos);
  EXPECT_NE(bad.error().line().find("shader"), std::string::npos);
}

}  // namespace
}  // namespace penpose::render
