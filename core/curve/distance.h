#pragma once

#include <algorithm>
#include <span>

#include "core/curve/stroke.h"

namespace penpose::curve {

/// From a place to the nearest one of a line of at least one point, px.
[[nodiscard]] inline double distance_to(std::span<const PxPoint> line, PxPoint p) {
  double nearest = geometry::distance(line.front(), p);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PxPoint along = line[i + 1] - line[i];
    const PxPoint from = p - line[i];
    const double square = along.x * along.x + along.y * along.y;
    const double share = square > 0.0 ? std::clamp((from.x * along.x + from.y * along.y) / square, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, geometry::distance(line[i] + along * share, p));
  }
  return nearest;
}

}  // namespace penpose::curve
