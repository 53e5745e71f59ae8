#pragma once

#include <algorithm>
#include <span>

#include "core/curve/stroke.h"

namespace penpose::curve {

/// Distance from a place to a line of at least one point, px.
[[nodiscard]] inline double distance_to(std::span<const PxPoint> line, PxPoint p) {
  double nearest = geometry::distance(line.front(), p);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double share = geometry::nearest_share(p, line[i], line[i + 1]);
    nearest = std::min(nearest, geometry::distance(line[i] + (line[i + 1] - line[i]) * share, p));
  }
  return nearest;
}

}  // namespace penpose::curve
