#pragma once

#include <span>
#include <vector>

#include "core/articulation/region/canvas.h"

namespace penpose::sketches {

using geometry::ModelPoint;

/// What a pose does to a surface, told by nothing but the surface at rest and posed.
struct SurfaceCheck {
  /// Triangles whose corner normals (the mean over the triangles about each corner) run against the triangle's own now
  /// and did not at rest: those of a fold, whichever way the whole has turned.
  std::size_t against_neighbours = 0;
  /// Edges at which two triangles now lie on each other (normals at more than 120 degrees) and at rest lay at less than
  /// 90.
  std::size_t creases = 0;
  double stretch = 1;         ///< the largest ratio of an edge's length to that at rest
  std::size_t stretched = 0;  ///< edges over three times
};

[[nodiscard]] SurfaceCheck check_surface(const articulation::Canvas& canvas, std::span<const ModelPoint> posed,
                                         std::span<const std::uint32_t> moved);

}  // namespace penpose::sketches
