#include "ui/render/gl/framebuffers.h"

#include <gtest/gtest.h>

#include "ui/render/gl/offscreen_context.h"

namespace penpose::render {
namespace {

TEST(Framebuffers, HaveTheSizeAskedFor) {
  const auto context = OffscreenContext::make(DrawWay::gl);
  ASSERT_TRUE(context.ok());
  Framebuffers targets{GlDialect{}};
  ASSERT_TRUE(targets.resize(33, 17).ok());
  EXPECT_GE(targets.samples(), 4);
  const Image image = targets.read();
  EXPECT_EQ(image.width, 33);
  EXPECT_EQ(image.pixels.size(), 33U * 17 * 4);
}

TEST(Framebuffers, RefuseWhatTheDriverCannotAndGoOn) {
  const auto context = OffscreenContext::make(DrawWay::gl);
  ASSERT_TRUE(context.ok());
  Framebuffers targets{GlDialect{}};
  EXPECT_FALSE(targets.resize(1 << 24, 4).ok());
  EXPECT_FALSE(targets.resize(0, 4).ok());
  EXPECT_TRUE(targets.resize(8, 8).ok());
}

}  // namespace
}  // namespace penpose::render
