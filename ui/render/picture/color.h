#pragma once

#include <cstdint>

namespace penpose::render {

/// A colour in linear light, 0..1, with straight alpha.
struct Color {
  float r = 0, g = 0, b = 0, a = 1;
  friend bool operator==(const Color&, const Color&) = default;
};

/// The colour of a display value 0xRRGGBB (sRGB, IEC 61966-2-1).
[[nodiscard]] Color from_srgb(std::uint32_t rgb, float alpha = 1);
/// Display value 0..1 of a linear one; clamps.
[[nodiscard]] float encode_srgb(float linear);
/// Linear value of a display value 0..1.
[[nodiscard]] float decode_srgb(float display);
/// From a to b by t in 0..1, in linear light.
[[nodiscard]] Color mix(const Color& a, const Color& b, float t);

/// The colour of a region's weight: 0 white, 1/2 blue, 1 black (method, regions). Clamps.
[[nodiscard]] Color weight_color(float weight);

}  // namespace penpose::render
