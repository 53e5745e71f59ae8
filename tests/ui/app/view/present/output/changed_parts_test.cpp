#include "ui/app/view/present/output/changed_parts.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

render::Image plain(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height))};
}

void dot(render::Image& picture, int x, int y) {
  picture.pixels[static_cast<std::size_t>(4 * (y * picture.width + x))] = 255;
}

bool hold(const std::vector<render::PxRect>& parts, int x, int y) {
  for (const render::PxRect& part : parts) {
    if (x >= part.left && x < part.right && y >= part.top && y < part.bottom) return true;
  }
  return false;
}

int area_of(const std::vector<render::PxRect>& parts) {
  int area = 0;
  for (const render::PxRect& part : parts) area += (part.right - part.left) * (part.bottom - part.top);
  return area;
}

TEST(ChangedParts, TheSamePictureHasNone) { EXPECT_TRUE(changed_parts(plain(801, 479), plain(801, 479)).empty()); }

TEST(ChangedParts, AStrokeIsAStripAndAPanelElsewhereAnother) {
  const render::Image before = plain(801, 479);
  render::Image now = before;
  for (int x = 200; x < 300; ++x) dot(now, x, 240);
  dot(now, 800, 478);
  const auto parts = changed_parts(before, now);
  for (int x = 200; x < 300; ++x) EXPECT_TRUE(hold(parts, x, 240));
  EXPECT_TRUE(hold(parts, 800, 478));
  EXPECT_EQ(parts.size(), 2U);
  EXPECT_LT(area_of(parts), 3000);
}

TEST(ChangedParts, ManySmallOnesAreFewRectangles) {
  const render::Image before = plain(640, 480);
  render::Image now = before;
  for (int i = 0; i < 20; ++i) dot(now, 32 * i, 24 * i);
  const auto parts = changed_parts(before, now);
  EXPECT_LE(parts.size(), 16U);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(hold(parts, 32 * i, 24 * i));
}

TEST(ChangedParts, AnotherSizeIsAllOfIt) { EXPECT_EQ(area_of(changed_parts(plain(10, 10), plain(64, 48))), 64 * 48); }

}  // namespace
}  // namespace penpose::app
