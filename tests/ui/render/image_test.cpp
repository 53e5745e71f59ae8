#include "ui/render/image.h"

#include <gtest/gtest.h>
#include <png.h>

namespace penpose::render {
namespace {

TEST(Image, PngHoldsThePixels) {
  Image image{3, 2, {}};
  for (int i = 0; i < 24; ++i) image.pixels.push_back(static_cast<std::uint8_t>(i * 10));
  const auto bytes = encode_png(image);
  ASSERT_TRUE(bytes.ok());
  png_image read{};
  read.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&read, bytes->data(), bytes->size()), 0);
  read.format = PNG_FORMAT_RGBA;
  EXPECT_EQ(read.width, 3U);
  EXPECT_EQ(read.height, 2U);
  std::vector<std::uint8_t> pixels(24);
  ASSERT_NE(png_image_finish_read(&read, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels, image.pixels);
}

TEST(Image, ASizeThatDoesNotFitIsRefused) {
  EXPECT_FALSE(encode_png({2, 2, std::vector<std::uint8_t>(15)}).ok());
  EXPECT_FALSE(encode_png({0, 0, {}}).ok());
}

}  // namespace
}  // namespace penpose::render
