#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::curve {

using geometry::ModelPoint;
using geometry::PxPoint;

/// One report of the pen while drawing.
struct StrokeSample {
  PxPoint position;
  double pressure = 1;       ///< 0..1
  std::int64_t time_us = 0;  ///< of the device's clock
  friend bool operator==(const StrokeSample&, const StrokeSample&) = default;
};

/// The samples from pen-down to pen-up.
using Stroke = std::vector<StrokeSample>;

[[nodiscard]] std::vector<PxPoint> positions_of(const Stroke& stroke);

}  // namespace penpose::curve
