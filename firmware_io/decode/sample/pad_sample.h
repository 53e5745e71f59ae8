#pragma once

#include <array>
#include <cstdint>

#include "firmware_io/decode/sample/pad_key.h"

namespace penpose::decode {

/// The side of a ring, strip or dial on its tablet.
inline constexpr std::size_t k_pad_sides = 2;

/// The state of the keys and wheels on a tablet after a report, in the device's own units.
struct PadSample {
  PadKeys keys;                                   ///< the keys that are down
  std::array<std::int32_t, k_pad_sides> ring{};   ///< positions; 0 while not touched
  std::array<bool, k_pad_sides> ring_touched{};   ///< distinguishes a touch at 0 from none
  std::array<std::int32_t, k_pad_sides> strip{};  ///< the same; one bit for each place that is touched, or its number
  std::array<std::int32_t, k_pad_sides> wheel{};  ///< whole steps that this report turned; Linux's vertical one first
  std::array<std::int32_t, k_pad_sides> fine_wheel{};  ///< the same in 120ths of a step, if the device has them
  std::array<std::int8_t, k_pad_sides> mode{};         ///< the light that is on at a ring or strip, from 0

  friend bool operator==(const PadSample&, const PadSample&) = default;
};

/// The controls of a pad. Counts are 0 to k_pad_sides.
struct PadFeatures {
  PadKeys keys;  ///< the existing keys
  unsigned rings = 0;
  unsigned strips = 0;
  unsigned wheels = 0;
  unsigned modes = 0;              ///< groups of lights that show a mode
  unsigned lights = 0;             ///< lights in each group
  std::int32_t ring_maximum = 0;   ///< largest position of a ring
  std::int32_t strip_maximum = 0;  ///< largest value of a strip
  PadKeys mode_keys;               ///< the keys that advance or choose a light
  bool wheels_clockwise = false;   ///< wheels count clockwise; Linux's count away from oneself

  [[nodiscard]] bool any() const { return !keys.empty() || rings + strips + wheels != 0; }
};

/// The charge of a tablet's battery.
struct Battery {
  std::int8_t percent = -1;  ///< -1: unknown
  bool charging = false;

  friend bool operator==(const Battery&, const Battery&) = default;
};

}  // namespace penpose::decode
