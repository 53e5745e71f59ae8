#include "ui/render/cpu/shading/texture_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/math.h"
#include "ui/render/cpu/shading/srgb_tables.h"
#include "ui/render/picture/color.h"

namespace penpose::render {
namespace {

/// Averages four px, or two where one side is a single px, in linear light.
Image half_of(const Image& image) {
  const SrgbTables& srgb = SrgbTables::get();
  Image half{std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
  half.pixels.reserve(static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height) * 4);
  for (int y = 0; y < half.height; ++y) {
    const int below = std::min(2 * y + 1, image.height - 1);
    for (int x = 0; x < half.width; ++x) {
      const int right = std::min(2 * x + 1, image.width - 1);
      const std::uint8_t* const four[4] = {image.at(2 * x, 2 * y), image.at(right, 2 * y), image.at(2 * x, below),
                                           image.at(right, below)};
      for (int c = 0; c < 3; ++c) {
        float sum = 0;
        for (const std::uint8_t* one : four) sum += srgb.linear(one[c]);
        half.pixels.push_back(static_cast<std::uint8_t>(srgb.display_of_root(std::sqrt(sum * 0.25F)) * 255.0F + 0.5F));
      }
      const int alpha = four[0][3] + four[1][3] + four[2][3] + four[3][3];
      half.pixels.push_back(static_cast<std::uint8_t>((alpha + 2) / 4));
    }
  }
  return half;
}

/// Which px of a side stands for that one.
int wrapped(int at, int size, document::Wrap wrap) {
  if (wrap == document::Wrap::clamp) return std::clamp(at, 0, size - 1);
  if (wrap == document::Wrap::repeat) {
    const int rest = at % size;
    return rest < 0 ? rest + size : rest;
  }
  const int both = 2 * size;
  const int rest = ((at % both) + both) % both;
  return rest < size ? rest : both - 1 - rest;
}

/// Numbers of px that fit an int, also of coordinates that are none.
float held(float value) { return value > -1e6F ? (value < 1e6F ? value : 1e6F) : -1e6F; }

}  // namespace

TextureMap::TextureMap(Image image) {
  levels_.push_back(std::move(image));
  while (levels_.back().width > 1 || levels_.back().height > 1) levels_.push_back(half_of(levels_.back()));
}

glm::vec4 TextureMap::sample_level(const document::TextureUse& use, std::size_t level, const glm::vec2& at,
                                   bool nearest) const {
  const Image& image = levels_[level];
  const SrgbTables& srgb = SrgbTables::get();
  const auto read = [&](int x, int y) {
    const std::uint8_t* p = image.at(wrapped(x, image.width, use.wrap_u), wrapped(y, image.height, use.wrap_v));
    return glm::vec4(srgb.linear(p[0]), srgb.linear(p[1]), srgb.linear(p[2]), static_cast<float>(p[3]) / 255.0F);
  };
  const float x = held(at.x * static_cast<float>(image.width));
  const float y = held(at.y * static_cast<float>(image.height));
  if (nearest) return read(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
  const float left = std::floor(x - 0.5F);
  const float top = std::floor(y - 0.5F);
  const float right_share = x - 0.5F - left;
  const float lower_share = y - 0.5F - top;
  const int column = static_cast<int>(left);
  const int row = static_cast<int>(top);
  const glm::vec4 upper = read(column, row) * (1.0F - right_share) + read(column + 1, row) * right_share;
  const glm::vec4 lower = read(column, row + 1) * (1.0F - right_share) + read(column + 1, row + 1) * right_share;
  return upper * (1.0F - lower_share) + lower * lower_share;
}

glm::vec4 TextureMap::sample(const document::TextureUse& use, const glm::vec2& at, const glm::vec2& along_x,
                             const glm::vec2& along_y) const {
  const auto px2 = [&](const glm::vec2& change) {
    const float u = change.x * static_cast<float>(levels_[0].width);
    const float v = change.y * static_cast<float>(levels_[0].height);
    return u * u + v * v;
  };
  // The level is the logarithm of the longer change, in px of the picture.
  const float longest2 = std::max(px2(along_x), px2(along_y));
  if (!(longest2 > 1.0F)) return sample_level(use, 0, at, use.nearest);
  int exponent = 0;
  const float part = std::frexp(std::min(longest2, 1e12F), &exponent);  // 0.5..1
  // log2 of 0.5..1 by a polynomial fitted to it, within 0.002; half of the logarithm of the square.
  const float log_part = -3.133887F + part * (6.021702F + part * (-4.118234F + part * 1.231397F));
  const float level = std::max(0.0F, 0.5F * (static_cast<float>(exponent) + log_part));
  const auto last = static_cast<float>(levels_.size() - 1);
  if (level >= last) return sample_level(use, levels_.size() - 1, at, false);
  const auto lower = static_cast<std::size_t>(level);
  const float share = level - static_cast<float>(lower);
  return sample_level(use, lower, at, false) * (1.0F - share) + sample_level(use, lower + 1, at, false) * share;
}

}  // namespace penpose::render
