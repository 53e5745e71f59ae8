#pragma once

#include <cstdint>

namespace penpose::decode {

enum class Tool : std::uint8_t { none, pen, eraser, mouse };

/// The state of a pen in one report, in the device's own units, neither scaled nor filtered. A field that the device
/// does not have is zero and its bit in `AxisSet` (see PenAxes) is clear.
struct PenSample {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t pressure = 0;
  std::int32_t tilt_x = 0;
  std::int32_t tilt_y = 0;
  std::int32_t distance = 0;  ///< as Linux has it: grows away from the tablet, but for Z of makers other than Wacom
  std::int32_t rotation = 0;
  std::int32_t wheel = 0;
  std::uint64_t serial = 0;
  std::uint32_t tool_id = 0;
  std::uint32_t buttons = 0;  ///< bit 0: first barrel button, bit 1: second, ...; of a mouse: left, right, middle, ...
  Tool tool = Tool::none;     ///< none while nothing is in range
  bool in_range = false;
  bool tip = false;

  friend bool operator==(const PenSample&, const PenSample&) = default;
};

/// The range of one axis as the device declares it. `units_per_mm` is 0 where it is unknown (for tilt: units per
/// degree).
struct Axis {
  std::int32_t minimum = 0;
  std::int32_t maximum = 0;
  double units_per_mm = 0;
  bool present = false;
};

struct PenAxes {
  Axis x, y, pressure, tilt_x, tilt_y, distance, rotation, wheel;
};

}  // namespace penpose::decode
