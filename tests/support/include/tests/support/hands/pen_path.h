#pragma once

#include <cstdint>
#include <vector>

#include "firmware_io/decode/sample/pen_sample.h"

namespace penpose::tests {

/// What a tablet of a test can express.
struct PathLimits {
  std::int32_t max_x = 10000, max_y = 8000;
  std::int32_t max_pressure = 1023;
  bool tilt = false;
  /// Pressure above which the device counts a contact; -1 where it has a tip switch.
  std::int32_t contact_above = -1;
};

/// A pen that comes near, hovers, draws a line with swelling pressure while a button is held for a while, lifts and
/// leaves: `strokes` times, the last time with the eraser end. Every sample differs from the one before it.
inline std::vector<decode::PenSample> pen_path(const PathLimits& limits, int strokes = 3, int points = 20) {
  std::vector<decode::PenSample> path;
  for (int stroke = 0; stroke < strokes; ++stroke) {
    const bool eraser = stroke + 1 == strokes;
    for (int i = 0; i < points; ++i) {
      decode::PenSample sample;
      sample.in_range = true;
      sample.tool = eraser ? decode::Tool::eraser : decode::Tool::pen;
      sample.x = limits.max_x / 10 + (limits.max_x * 8 / 10) * i / points + stroke;
      sample.y = limits.max_y / 4 + (limits.max_y / 2) * ((i * i) % points) / points + stroke * 2;
      const bool touching = i >= 3 && i < points - 3;
      if (touching) {
        const int swell = i < points / 2 ? i : points - i;
        sample.pressure = limits.max_pressure / 4 + (limits.max_pressure / 2) * swell / points;
        sample.tip = limits.contact_above < 0 || sample.pressure > limits.contact_above;
      }
      if (!eraser && i >= points / 2 && i < points / 2 + 4) sample.buttons = 1;
      if (limits.tilt) {
        sample.tilt_x = -60 + 6 * i;
        sample.tilt_y = 60 - 5 * i;
      }
      path.push_back(sample);
    }
    path.push_back({});  // away
  }
  return path;
}

}  // namespace penpose::tests
