#include "ui/render/picture/color.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::render {
namespace {

/// The same bits on every machine: pictures of the processor are compared by equality.
float power(float value, double exponent) {
  return static_cast<float>(base::pow(static_cast<double>(value), exponent));
}

}  // namespace

float decode_srgb(float display) {
  const float v = std::clamp(display, 0.0F, 1.0F);
  return v <= 0.04045F ? v / 12.92F : power((v + 0.055F) / 1.055F, 2.4);
}

float encode_srgb(float linear) {
  const float v = std::clamp(linear, 0.0F, 1.0F);
  return v <= 0.0031308F ? v * 12.92F : 1.055F * power(v, 1.0 / 2.4) - 0.055F;
}

Color from_srgb(std::uint32_t rgb, float alpha) {
  const auto channel = [&](unsigned shift) { return decode_srgb(static_cast<float>((rgb >> shift) & 0xffU) / 255.0F); };
  return {channel(16), channel(8), channel(0), alpha};
}

Color mix(const Color& a, const Color& b, float t) {
  return {std::lerp(a.r, b.r, t), std::lerp(a.g, b.g, t), std::lerp(a.b, b.b, t), std::lerp(a.a, b.a, t)};
}

Color weight_color(float weight) {
  const Color white = from_srgb(0xf4f4f4);
  const Color blue = from_srgb(0x1f5fd0);
  const Color black = from_srgb(0x0a0a12);
  const float w = std::clamp(weight, 0.0F, 1.0F);
  return w < 0.5F ? mix(white, blue, w * 2) : mix(blue, black, w * 2 - 1);
}

}  // namespace penpose::render
