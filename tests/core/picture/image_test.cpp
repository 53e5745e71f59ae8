#include "core/picture/image.h"

#include <gtest/gtest.h>
#include <png.h>
#include <span>

namespace penpose::picture {
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

void put_big_endian(std::vector<std::uint8_t>& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

/// The check sum of a PNG chunk (RFC 2083, section 15).
std::uint32_t check_sum(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = 0xffffffff;
  for (const std::uint8_t byte : bytes) {
    sum ^= byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1) != 0 ? (sum >> 1) ^ 0xedb88320 : sum >> 1;
  }
  return ~sum;
}

// A header of a few bytes was a gigabyte of memory before the first pixel was missed.
TEST(Image, AHeaderAloneIsNoHugePicture) {
  auto bytes = encode_png(Image{2, 2, std::vector<std::uint8_t>(16, 100)}).value();
  ASSERT_TRUE(decode_png(bytes));
  constexpr std::size_t k_header = 12;  // where "IHDR" begins
  put_big_endian(bytes, k_header + 4, 16384);
  put_big_endian(bytes, k_header + 8, 16384);
  put_big_endian(bytes, k_header + 17, check_sum(std::span(bytes).subspan(k_header, 17)));
  const auto huge = decode_png(bytes);
  ASSERT_FALSE(huge);
  EXPECT_NE(huge.error().what.find("far more pixels"), std::string::npos) << huge.error().what;
}

TEST(Image, ASizeThatDoesNotFitIsRefused) {
  EXPECT_FALSE(encode_png({2, 2, std::vector<std::uint8_t>(15)}).ok());
  EXPECT_FALSE(encode_png({0, 0, {}}).ok());
}

}  // namespace
}  // namespace penpose::picture
