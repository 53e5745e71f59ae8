#pragma once

#include <array>

#include "core/document/look.h"

namespace penpose::render {

/// Points of surfaces that are lighted together, each number in an array of its own, so that compilers take several at
/// once. Vectors are in the camera's space: x right, y up, z towards the eye.
struct Fragments {
  static constexpr int k_most = 256;
  static constexpr int k_beyond = 4;  ///< numbers behind the last that may be written
  using Numbers = std::array<float, k_most + k_beyond>;

  int count = 0;
  alignas(32) Numbers normal_x, normal_y, normal_z;  ///< of any length
  alignas(32) Numbers eye_x, eye_y;                  ///< px; then towards the eye, as far as the plane at distance 1
  alignas(32) Numbers red, green, blue;              ///< base colour, linear
  alignas(32) Numbers roughness, metallic;
  alignas(32) Numbers open;  ///< share of the light that comes in
  alignas(32) Numbers lit;   ///< 1: lighted; 0: shown as its base colour
  alignas(32) Numbers sky;   ///< share of the light from all sides that comes in
  alignas(32) Numbers coat;  ///< 1: the wet front of an eye, which mirrors a window

  /// Where one has two tones: how, and its shade's colour, linear.
  struct Tones {
    const document::Toon* toon = nullptr;  ///< null: it has none
    bool outline = false;
    float red = 0, green = 0, blue = 0;
  };
  std::array<Tones, k_most + k_beyond> tones;
  bool some_coat = false;   ///< some of them may have a coat
  bool some_tones = false;  ///< some of them may have tones
  bool matcap = false;      ///< lit as a ball is; stays from call to call

  // What `shade` gives: what is displayed, 0..1, and how much brighter than its diffuse colour red is.
  alignas(32) Numbers shown_red, shown_green, shown_blue;
  alignas(32) Numbers shine;
};

/// From px to the camera's space, of a plane at distance 1: x' = x * scale.x + shift.x, and so for y.
struct PxToEye {
  float scale_x, shift_x, scale_y, shift_y;
};

/// Lights them as the shaders of ui/render/gl do (k_lights in shaders.h, where the sources are named). The same bits on
/// every machine: IEEE additions, multiplications, divisions and square roots in a written order.
void shade(Fragments& fragments, const PxToEye& eye);

}  // namespace penpose::render
