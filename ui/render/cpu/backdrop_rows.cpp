#include "ui/render/cpu/backdrop_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/render/cpu/mixing.h"

namespace penpose::render {
namespace {

constexpr int k_most = 64;  ///< px at a time

std::uint8_t byte_of(float value) { return static_cast<std::uint8_t>(value * 255.0F + 0.5F); }

}  // namespace

void draw_behind_row(const Behind& behind, int y, int left, std::span<std::uint8_t> row) {
  if (!behind.image || behind.from.x == behind.to.x || behind.from.y == behind.to.y) return;
  const Image& image = *behind.image;
  const auto height = static_cast<float>(behind.to.y - behind.from.y);
  const auto width = static_cast<float>(behind.to.x - behind.from.x);
  const float v = (static_cast<float>(y) + 0.5F - static_cast<float>(behind.from.y)) / height;
  if (!(v >= 0.0F && v <= 1.0F)) return;
  const float image_y = v * static_cast<float>(image.height) - 0.5F;
  const int top = static_cast<int>(std::floor(image_y));
  const float lower = image_y - static_cast<float>(top);
  const auto row_of = [&](int at) { return std::clamp(at, 0, image.height - 1); };
  for (std::size_t i = 0; i < row.size() / 4; ++i) {
    const float u = (static_cast<float>(left + static_cast<int>(i)) + 0.5F - static_cast<float>(behind.from.x)) / width;
    if (!(u >= 0.0F && u <= 1.0F)) continue;
    const float image_x = u * static_cast<float>(image.width) - 0.5F;
    const int column = static_cast<int>(std::floor(image_x));
    const float right = image_x - static_cast<float>(column);
    const auto read = [&](int x, int at_y, int c) {
      return static_cast<float>(image.at(std::clamp(x, 0, image.width - 1), row_of(at_y))[c]);
    };
    std::array<float, 4> color{};
    for (int c = 0; c < 4; ++c) {
      const float upper_row = read(column, top, c) * (1 - right) + read(column + 1, top, c) * right;
      const float lower_row = read(column, top + 1, c) * (1 - right) + read(column + 1, top + 1, c) * right;
      color[static_cast<std::size_t>(c)] = upper_row * (1 - lower) + lower_row * lower;
    }
    const float alpha = color[3] / 255.0F * behind.opacity;
    for (std::size_t c = 0; c < 3; ++c) blend(row[i * 4 + c], color[c], alpha);
  }
}

void draw_backdrop_row(const Background& colors, const Behind& behind, geometry::Viewport size, int y, int left,
                       std::span<std::uint8_t> row) {
  const float place_y = 1.0F - (static_cast<float>(y) + 0.5F) / static_cast<float>(size.height);
  const float t = place_y * place_y * (3.0F - 2.0F * place_y);
  const std::array<float, 3> color{
      encode_srgb(colors.bottom.r) * (1 - t) + encode_srgb(colors.top.r) * t,
      encode_srgb(colors.bottom.g) * (1 - t) + encode_srgb(colors.top.g) * t,
      encode_srgb(colors.bottom.b) * (1 - t) + encode_srgb(colors.top.b) * t,
  };
  const float dy = place_y - 0.55F;
  const float per_px = 1.0F / static_cast<float>(size.width);
  // Rows count from the foot where the noise was made for.
  const float noise_y = (static_cast<float>(size.height - 1 - y) + 0.5F) * 0.00583715F;
  const int count = static_cast<int>(row.size() / 4);
  for (int first = 0; first < count; first += k_most) {
    const int part = std::min(k_most, count - first);
    std::array<float, k_most> bright;  // NOLINT: what is read is written first
    std::array<float, k_most> noise;
    for (int i = 0; i < part; ++i) {
      const float px = static_cast<float>(left + first + i) + 0.5F;
      const float dx = px * per_px - 0.5F;
      bright[static_cast<std::size_t>(i)] = 1.12F - colors.vignette * (dx * dx + dy * dy);
      const float random = fraction(52.9829189F * fraction(px * 0.06711056F + noise_y));
      noise[static_cast<std::size_t>(i)] = (random - 0.5F) / 255.0F;
    }
    for (int i = 0; i < part; ++i) {
      std::uint8_t* const out = row.data() + static_cast<std::ptrdiff_t>(first + i) * 4;
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = color[c] * bright[static_cast<std::size_t>(i)] + noise[static_cast<std::size_t>(i)];
        out[c] = byte_of(value < 0.0F ? 0.0F : value > 1.0F ? 1.0F : value);
      }
      out[3] = 255;
    }
  }
  if (!behind.front) draw_behind_row(behind, y, left, row);
}

}  // namespace penpose::render
