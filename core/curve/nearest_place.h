#pragma once

#include <span>

#include "core/curve/polyline.h"

namespace penpose::curve {

/// Returns the place of a line that is nearest to a point; of equally near ones the first. Precondition: the line has
/// at least two points.
[[nodiscard]] inline PolylinePlace nearest_place(std::span<const PxPoint> line, PxPoint p) {
  PolylinePlace best;
  double nearest = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double share = geometry::nearest_share(p, line[k], line[k + 1]);
    const PxPoint off = p - line[k] - (line[k + 1] - line[k]) * share;
    const double squared = geometry::dot(off, off);
    if (k > 0 && squared >= nearest) continue;
    nearest = squared;
    best = {k, share};
  }
  return best;
}

}  // namespace penpose::curve
