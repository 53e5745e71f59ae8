#include "ui/render/gl/gl_program.h"

#include <gtest/gtest.h>

#include "ui/render/gl/offscreen_context.h"
#include "ui/render/gl/shaders.h"

namespace penpose::render {
namespace {

TEST(GlProgram, WhatTheDriverRefusesIsOneLine) {
  const auto context = OffscreenContext::make();
  ASSERT_TRUE(context.ok());
  EXPECT_TRUE(context_is_enough());
  EXPECT_TRUE(GlProgram::make(k_screen_vertex, k_background_fragment, {}).ok());
  const auto bad = GlProgram::make(k_screen_vertex, "void main() { nonsense }", {});
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().line().find('\n'), std::string::npos);
  EXPECT_NE(bad.error().line().find("shader"), std::string::npos);
}

}  // namespace
}  // namespace penpose::render
