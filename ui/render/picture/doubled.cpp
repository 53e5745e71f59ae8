#include "ui/render/picture/doubled.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace penpose::render {
namespace {

/// Three parts of one number and one of another, rounded.
std::uint8_t three_to_one(std::uint8_t near, std::uint8_t far) {
  return static_cast<std::uint8_t>((3U * near + far + 2U) >> 2U);
}

}  // namespace

void draw_doubled(const Image& small, Image& picture) {
  const std::size_t row_bytes = static_cast<std::size_t>(small.width) * 4;
  // A row with its first and last px once more outside.
  std::vector<std::uint8_t> row(row_bytes + 8);
  std::vector<std::uint8_t> left(row_bytes);
  std::vector<std::uint8_t> right(row_bytes);
  for (int y = 0; y < picture.height; ++y) {
    const int near = y / 2;
    const int far = std::clamp(y % 2 == 0 ? near - 1 : near + 1, 0, small.height - 1);
    const std::uint8_t* const a = small.at(0, near);
    const std::uint8_t* const b = small.at(0, far);
    std::uint8_t* const middle = row.data() + 4;
    for (std::size_t i = 0; i < row_bytes; ++i) middle[i] = three_to_one(a[i], b[i]);
    std::memcpy(row.data(), middle, 4);
    std::memcpy(middle + row_bytes, middle + row_bytes - 4, 4);
    for (std::size_t i = 0; i < row_bytes; ++i) left[i] = three_to_one(middle[i], row[i]);
    for (std::size_t i = 0; i < row_bytes; ++i) right[i] = three_to_one(middle[i], middle[i + 4]);
    std::uint8_t* out =
        picture.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) * 4;
    for (int x = 0; x + 1 < picture.width; x += 2, out += 8) {
      std::memcpy(out, left.data() + static_cast<std::ptrdiff_t>(x) * 2, 4);
      std::memcpy(out + 4, right.data() + static_cast<std::ptrdiff_t>(x) * 2, 4);
    }
    if (picture.width % 2 != 0) std::memcpy(out, left.data() + row_bytes - 4, 4);
  }
}

}  // namespace penpose::render
