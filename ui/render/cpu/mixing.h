#pragma once

#include <cstddef>
#include <cstdint>

#include "ui/render/picture/image.h"

// Small arithmetic of pictures, the same bits on every machine.
namespace penpose::render {

[[nodiscard]] inline float mixed(float a, float b, float t) { return a * (1.0F - t) + b * t; }

/// What of a number lies behind its point. Precondition: from zero on, and below 2^31.
[[nodiscard]] inline float fraction(float x) { return x - static_cast<float>(static_cast<std::int32_t>(x)); }

/// The 4 bytes of a px, to be written.
[[nodiscard]] inline std::uint8_t* px_of(Image& picture, int x, int y) {
  return picture.pixels.data() +
         (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x)) * 4;
}

/// Lays a colour, 0..255 as displayed, over a byte by its alpha, 0..1.
inline void blend(std::uint8_t& out, float color, float alpha) {
  const float value = color * alpha + static_cast<float>(out) * (1.0F - alpha) + 0.5F;
  out = static_cast<std::uint8_t>(value < 255.0F ? value : 255.0F);
}

}  // namespace penpose::render
