#include "core/picture/decode_picture.h"

#include <gtest/gtest.h>
#include <webp/encode.h>

namespace penpose::picture {
namespace {

/// A picture whose px say where they are.
Image numbered(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixels.insert(image.pixels.end(), {static_cast<std::uint8_t>(x * 255 / width),
                                               static_cast<std::uint8_t>(y * 255 / height), 40, 255});
    }
  }
  return image;
}

std::vector<std::uint8_t> webp_of(const Image& image) {
  std::uint8_t* out = nullptr;
  const std::size_t size =
      WebPEncodeLosslessRGBA(image.pixels.data(), image.width, image.height, image.width * 4, &out);
  std::vector<std::uint8_t> bytes(out, out + size);
  WebPFree(out);
  return bytes;
}

TEST(TexturePicture, PngAndWebpComeBackAsTheyWere) {
  const Image image = numbered(60, 34);
  const auto png = encode_png(image).value();
  EXPECT_EQ(decode_picture(png, 64).value(), image);
  EXPECT_EQ(decode_picture(webp_of(image), 64).value(), image);
}

TEST(TexturePicture, LargeOnesAreMadeSmallerWhileTheyAreRead) {
  const Image image = numbered(300, 130);
  for (const auto& bytes : {encode_png(image).value(), webp_of(image)}) {
    const auto small = decode_picture(bytes, 100);
    ASSERT_TRUE(small.ok());
    EXPECT_EQ(small->width, 100);
    EXPECT_EQ(small->height, 44);
    EXPECT_NEAR(small->at(50, 20)[0], 50 * 255 / 100, 4);
    EXPECT_NEAR(small->at(50, 20)[1], 20 * 255 / 44, 6);
    EXPECT_EQ(small->at(99, 43)[3], 255);
  }
}

TEST(TexturePicture, WhatIsCutDamagedOrOfAnotherKindIsAnError) {
  const Image image = numbered(60, 34);
  for (const auto& bytes : {encode_png(image).value(), webp_of(image)}) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{5}, std::size_t{20}, bytes.size() / 2}) {
      EXPECT_FALSE(decode_picture(std::span(bytes).first(size), 64).ok()) << size;
    }
  }
  const std::vector<std::uint8_t> text{'h', 'e', 'l', 'l', 'o'};
  EXPECT_FALSE(decode_picture(text, 64).ok());
}

TEST(TexturePicture, AHugeSizeInAFewBytesIsRefusedBeforeMemoryIsTaken) {
  auto bytes = encode_png(numbered(4, 4)).value();
  // 16384 x 16384 in IHDR; its check sum is wrong then, which is an error as good.
  bytes[18] = bytes[22] = 0x40;
  bytes[19] = bytes[23] = 0;
  EXPECT_FALSE(decode_picture(bytes, 2048).ok());
}

}  // namespace
}  // namespace penpose::picture
