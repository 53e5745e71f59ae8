#include "ui/render/gl/offscreen_context.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace penpose::render {
namespace {

TEST(OffscreenContext, NeedsNoDisplay) {
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  const auto context = OffscreenContext::make(DrawWay::gl);
  EXPECT_TRUE(context.ok()) << (context.ok() ? "" : context.error().line());
}

TEST(OffscreenContext, CanBeMadeAgainAndTwice) {
  { ASSERT_TRUE(OffscreenContext::make(DrawWay::gl).ok()); }
  const auto first = OffscreenContext::make(DrawWay::gl);
  const auto second = OffscreenContext::make(DrawWay::gl);
  EXPECT_TRUE(first.ok());
  EXPECT_TRUE(second.ok());
}

TEST(OffscreenContext, WithoutADriverSaysWhatToInstallInOneLine) {
  // EGL finds its drivers by description files; none of these exists. Runs in a fresh process: a driver stays loaded.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", 1);
        const auto context = OffscreenContext::make(DrawWay::gl);
        const auto line = context.ok() ? "" : context.error().line();
        std::exit(
            !context.ok() && line.find("libegl1") != std::string::npos && line.find('\n') == std::string::npos ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace penpose::render
