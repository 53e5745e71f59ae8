#pragma once

#include "core/geometry/space.h"

namespace penpose::articulation {

/// The plane x = `x` that a model is symmetric about. Left of a character is +X (glTF: it looks along +Z, y is up).
struct SymmetryPlane {
  double x = 0;
};

[[nodiscard]] inline geometry::ModelPoint reflected(const geometry::ModelPoint& p, const SymmetryPlane& plane) {
  return {2.0 * plane.x - p.x, p.y, p.z};
}

}  // namespace penpose::articulation
