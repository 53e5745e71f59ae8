#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"

namespace penpose::picture {

/// A picture: rows from the top, pixels from the left, 4 bytes R G B A a pixel, sRGB.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;

  /// The 4 bytes of a pixel. Precondition: inside the picture.
  [[nodiscard]] const std::uint8_t* at(int x, int y) const {
    return pixels.data() +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 4;
  }
  friend bool operator==(const Image&, const Image&) = default;
};

/// The bytes of a PNG file. Errors: sizes that do not fit the pixels, or no memory.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> encode_png(const Image& image);

/// The picture of a PNG file. Errors: no PNG, damaged, or of more than 16384 px a side.
[[nodiscard]] base::Result<Image> decode_png(std::span<const std::uint8_t> bytes);

}  // namespace penpose::picture
