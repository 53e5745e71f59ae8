#include "ui/render/picture/doubled.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace penpose::render {
namespace {

/// Rounded up; compilers take sixteen at once.
inline std::uint8_t mean(std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a + b + 1) >> 1); }

/// Three parts of one row and one of another; none of them overlaps `out`.
void mix_three_to_one(const std::uint8_t* near, const std::uint8_t* far, std::size_t count,
                      std::uint8_t* __restrict out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = mean(near[i], mean(near[i], far[i]));
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
    mix_three_to_one(a, b, row_bytes, middle);
    std::memcpy(row.data(), middle, 4);
    std::memcpy(middle + row_bytes, middle + row_bytes - 4, 4);
    mix_three_to_one(middle, row.data(), row_bytes, left.data());
    mix_three_to_one(middle, middle + 4, row_bytes, right.data());
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
