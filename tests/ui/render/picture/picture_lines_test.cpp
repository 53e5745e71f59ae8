#include "ui/render/picture/picture_lines.h"

#include <gtest/gtest.h>
#include <png.h>
#include <string>
#include <vector>

#include "tests/support/drawings/drawn_paper.h"
#include "ui/render/picture/image.h"

namespace penpose::render {
namespace {

using geometry::PxPoint;
using tests::Points;

const Points k_brow{{20, 60}, {100, 30}, {180, 60}};

std::vector<std::uint8_t> drawn_pixels() { return tests::DrawnPaper(200, 100).draw(k_brow, 3).pixels(); }

void expect_brow(base::Bytes bytes, const std::string& what) {
  const auto drawing = read_picture_lines(bytes);
  ASSERT_TRUE(drawing.ok()) << what << ": " << drawing.error().line();
  ASSERT_EQ(drawing->lines.size(), 1U) << what;
  EXPECT_LT(tests::deviation(drawing->lines[0].points, k_brow).mean, 0.2) << what;
  EXPECT_EQ(drawing->width, 200);
  EXPECT_EQ(drawing->height, 100);
}

/// A PNG of one of libpng's simplified formats.
std::vector<std::uint8_t> png_of(png_uint_32 format, const std::vector<std::uint8_t>& rgba) {
  const std::size_t count = rgba.size() / 4;
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> words;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t grey = rgba[i * 4];
    if (format == PNG_FORMAT_GRAY || format == PNG_FORMAT_RGB_COLORMAP) bytes.push_back(grey);
    if (format == PNG_FORMAT_RGB) bytes.insert(bytes.end(), 3, grey);
    // Black ink on nothing.
    if (format == PNG_FORMAT_GA) bytes.insert(bytes.end(), {0, static_cast<std::uint8_t>(255 - grey)});
    if (format == PNG_FORMAT_LINEAR_Y) words.push_back(static_cast<std::uint16_t>(grey * 257));
  }
  std::vector<std::uint8_t> map;
  for (int i = 0; i < 256; ++i) map.insert(map.end(), 3, static_cast<std::uint8_t>(i));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = 200;
  image.height = 100;
  image.format = format;
  image.colormap_entries = 256;
  const void* pixels = words.empty() ? static_cast<const void*>(bytes.data()) : words.data();
  png_alloc_size_t size = 0;
  EXPECT_NE(png_image_write_to_memory(&image, nullptr, &size, 0, pixels, 0, map.data()), 0) << image.message;
  std::vector<std::uint8_t> file(size);
  EXPECT_NE(png_image_write_to_memory(&image, file.data(), &size, 0, pixels, 0, map.data()), 0) << image.message;
  file.resize(size);
  return file;
}

TEST(PictureLines, OfEveryKindOfPng) {
  const auto rgba = drawn_pixels();
  const auto plain = encode_png({200, 100, rgba});
  ASSERT_TRUE(plain.ok());
  expect_brow(*plain, "RGBA");
  expect_brow(png_of(PNG_FORMAT_GRAY, rgba), "grey");
  expect_brow(png_of(PNG_FORMAT_RGB, rgba), "RGB");
  expect_brow(png_of(PNG_FORMAT_GA, rgba), "grey with alpha");
  expect_brow(png_of(PNG_FORMAT_RGB_COLORMAP, rgba), "palette");
  expect_brow(png_of(PNG_FORMAT_LINEAR_Y, rgba), "16 bit");
}

TEST(PictureLines, OfAnSvg) {
  const std::string svg =
      "<svg viewBox='0 0 200 100'><polyline fill='none' stroke='red' points='20 60 100 30 180 60'/></svg>";
  expect_brow(base::as_bytes(svg), "SVG");
}

TEST(PictureLines, LargePicturesAreInPxOfTheFile) {
  Image large{5000, 50, std::vector<std::uint8_t>(5000 * 50 * 4, 255)};
  for (int y = 20; y < 26; ++y) {
    for (int x = 1000; x < 4000; ++x) {
      for (std::size_t c = 0; c < 3; ++c) large.pixels[static_cast<std::size_t>(y * 5000 + x) * 4 + c] = 0;
    }
  }
  const auto png = encode_png(large);
  ASSERT_TRUE(png.ok());
  const auto drawing = read_picture_lines(*png);
  ASSERT_TRUE(drawing.ok()) << drawing.error().line();
  ASSERT_EQ(drawing->lines.size(), 1U);
  EXPECT_EQ(drawing->width, 5000);
  for (const PxPoint& p : drawing->lines[0].points) EXPECT_NEAR(p.y, 23, 0.3);
  EXPECT_NEAR(drawing->lines[0].points.front().x, 1000, 4);
  EXPECT_NEAR(drawing->lines[0].points.back().x, 4000, 4);
}

TEST(PictureLines, WhatIsNoDrawingIsRefused) {
  const auto error = [](base::Bytes bytes) {
    const auto drawing = read_picture_lines(bytes);
    return drawing ? "(no error)" : drawing.error().line("a");
  };
  EXPECT_EQ(error({}), "a: is no drawing that can be read; choose an SVG, PNG, JPEG or WebP file");
  EXPECT_EQ(error(base::as_bytes("GIF89a")),
            "a: is no drawing that can be read; choose an SVG, PNG, JPEG or WebP file");
  const auto png = encode_png({200, 100, drawn_pixels()});
  ASSERT_TRUE(png.ok());
  EXPECT_NE(error(base::Bytes(*png).first(png->size() / 2)).find("; export the picture again"), std::string::npos);
}

}  // namespace
}  // namespace penpose::render
