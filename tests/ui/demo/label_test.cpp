#include "ui/demo/label.h"

#include <gtest/gtest.h>

namespace penpose::demo {
namespace {

render::Image blank() { return {40, 20, std::vector<std::uint8_t>(40 * 20 * 4, 100)}; }

std::size_t white_pixels(const render::Image& image) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) count += image.pixels[i] == 255 ? 1 : 0;
  return count;
}

TEST(Label, LettersHaveTheirDots) {
  render::Image image = blank();
  draw_label(image, 2, 3, 1, "L", {1, 1, 1, 1});
  EXPECT_EQ(white_pixels(image), 11U);  // a stem of seven and four more in the foot
  EXPECT_EQ(image.at(2, 3)[0], 255);
  EXPECT_EQ(image.at(6, 9)[0], 255);
  EXPECT_EQ(image.at(6, 3)[0], 100);
  draw_label(image, 2, 3, 1, "l", {1, 1, 1, 1});
  EXPECT_EQ(white_pixels(image), 11U);
}

TEST(Label, ScaleMakesDotsLargerAndOtherSignsAreSpaces) {
  render::Image image = blank();
  draw_label(image, 0, 0, 2, "_-L", {1, 1, 1, 1});
  EXPECT_EQ(white_pixels(image), 44U);
  EXPECT_EQ(image.at(24, 0)[0], 255);
}

TEST(Label, WhatLiesOutsideIsCutOff) {
  render::Image image = blank();
  draw_label(image, 38, 17, 3, "M", {1, 1, 1, 1});
  draw_label(image, -4, -5, 1, "M0", {1, 1, 1, 1});
  EXPECT_EQ(image.pixels.size(), 40U * 20 * 4);
  EXPECT_GT(white_pixels(image), 0U);
}

}  // namespace
}  // namespace penpose::demo
