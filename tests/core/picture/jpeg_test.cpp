#include "core/picture/jpeg.h"

#include <cstddef>
#include <cstdio>
//
#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <jpeglib.h>
#include <string>

namespace penpose::picture {
namespace {

/// A picture whose left half is one colour and whose right half is another, as libjpeg writes it.
std::vector<std::uint8_t> two_halves(unsigned width, unsigned height, bool grey = false) {
  jpeg_compress_struct writer{};
  jpeg_error_mgr errors{};
  writer.err = jpeg_std_error(&errors);
  jpeg_create_compress(&writer);
  unsigned char* out = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): libjpeg's type
  jpeg_mem_dest(&writer, &out, &size);
  writer.image_width = width;
  writer.image_height = height;
  writer.input_components = grey ? 1 : 3;
  writer.in_color_space = grey ? JCS_GRAYSCALE : JCS_RGB;
  jpeg_set_defaults(&writer);
  jpeg_set_quality(&writer, 95, TRUE);
  jpeg_start_compress(&writer, TRUE);
  std::vector<std::uint8_t> row;
  for (unsigned x = 0; x < width; ++x) {
    if (grey) {
      row.push_back(x < width / 2 ? 30 : 220);
    } else {
      row.insert(row.end(), {std::uint8_t(x < width / 2 ? 200 : 20), 40, std::uint8_t(x < width / 2 ? 30 : 190)});
    }
  }
  while (writer.next_scanline < height) {
    JSAMPROW line = row.data();
    jpeg_write_scanlines(&writer, &line, 1);
  }
  jpeg_finish_compress(&writer);
  std::vector<std::uint8_t> bytes(out, out + size);
  jpeg_destroy_compress(&writer);
  std::free(out);
  return bytes;
}

void expect_near(const std::uint8_t* pixel, int r, int g, int b) {
  EXPECT_NEAR(pixel[0], r, 8);
  EXPECT_NEAR(pixel[1], g, 8);
  EXPECT_NEAR(pixel[2], b, 8);
  EXPECT_EQ(pixel[3], 255);
}

TEST(Jpeg, ColoursAndGreysAreWhereTheyWere) {
  const auto image = decode_jpeg(two_halves(64, 32));
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 64);
  EXPECT_EQ(image->height, 32);
  expect_near(image->at(8, 16), 200, 40, 30);
  expect_near(image->at(56, 16), 20, 40, 190);
  const auto grey = decode_jpeg(two_halves(64, 32, true));
  ASSERT_TRUE(grey.ok());
  expect_near(grey->at(8, 2), 30, 30, 30);
}

TEST(Jpeg, LargePicturesAreHalvedWhileTheyAreRead) {
  const auto image = decode_jpeg(two_halves(1000, 600), 300);
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->width, 250);
  EXPECT_EQ(image->height, 150);
  expect_near(image->at(20, 75), 200, 40, 30);
}

TEST(Jpeg, WhatIsCutOffIsGreyOrAnErrorAndNeverACrash) {
  const auto whole = two_halves(64, 64);
  for (std::size_t size = 0; size < whole.size(); size += 3) {
    const auto image = decode_jpeg(std::span(whole).first(size));
    if (!image) {
      EXPECT_FALSE(image.error().what.empty());
      continue;
    }
    EXPECT_EQ(image->pixels.size(), 64U * 64 * 4);
  }
}

TEST(Jpeg, AFewBytesThatSayTheyAreHugeAreRefused) {
  auto bytes = two_halves(16, 16);
  for (std::size_t i = 0; i + 9 < bytes.size(); ++i) {
    if (bytes[i] != 0xff || bytes[i + 1] != 0xc0) continue;
    bytes[i + 5] = bytes[i + 7] = 0x3f;
    bytes[i + 6] = bytes[i + 8] = 0xff;
    break;
  }
  const auto image = decode_jpeg(bytes);
  ASSERT_FALSE(image.ok());
  EXPECT_NE(image.error().what.find("more pixels"), std::string::npos) << image.error().what;
}

TEST(Jpeg, OtherBytesAreNoPicture) {
  const std::string text = "this is no picture at all";
  const auto image = decode_jpeg({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  ASSERT_FALSE(image.ok());
  EXPECT_NE(image.error().what.find("no JPEG"), std::string::npos);
}

TEST(Jpeg, ShrinkingTakesTheMean) {
  Image image{4, 2, {}};
  for (int i = 0; i < 8; ++i)
    for (int c = 0; c < 4; ++c) image.pixels.push_back(static_cast<std::uint8_t>(i % 4 < 2 ? 10 * (i % 4) : 200));
  const Image small = shrunk(image, 2);
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 1);
  EXPECT_EQ(small.at(0, 0)[0], 5);
  EXPECT_EQ(small.at(1, 0)[0], 200);
  EXPECT_EQ(shrunk(image, 4), image);
}

}  // namespace
}  // namespace penpose::picture
