#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/geometry/camera.h"

namespace penpose::articulation {

/// A box of the picture. Empty until something is added.
struct PxBox {
  geometry::PxPoint minimum{1e300, 1e300};
  geometry::PxPoint maximum{-1e300, -1e300};

  void add(geometry::PxPoint p) {
    minimum = {std::min(minimum.x, p.x), std::min(minimum.y, p.y)};
    maximum = {std::max(maximum.x, p.x), std::max(maximum.y, p.y)};
  }
  [[nodiscard]] bool touches(const PxBox& other) const {
    return minimum.x <= other.maximum.x && maximum.x >= other.minimum.x && minimum.y <= other.maximum.y &&
           maximum.y >= other.minimum.y;
  }
};

/// The triangles that a stroke could hit, or that are within `around` px of it, so that a tree is built over a few
/// instead of all.
[[nodiscard]] std::vector<mesh::Triangle> triangles_under(const Canvas& canvas, const geometry::Camera& camera,
                                                          std::span<const geometry::PxPoint> stroke, double around = 1);

}  // namespace penpose::articulation
