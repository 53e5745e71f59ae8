#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ui/render/picture/color.h"

// How numbers of vertices are kept for drawing.
namespace penpose::render {

using Bytes4 = std::array<std::uint8_t, 4>;

inline std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

/// Square roots keep finer steps in the dark; whoever shades squares.
inline Bytes4 pack(const Color& c) {
  return {to_byte(std::sqrt(std::max(c.r, 0.0F))), to_byte(std::sqrt(std::max(c.g, 0.0F))),
          to_byte(std::sqrt(std::max(c.b, 0.0F))), to_byte(c.a)};
}

}  // namespace penpose::render
