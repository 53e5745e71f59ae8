#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/curve/stroke.h"
#include "core/geometry/bvh.h"
#include "core/geometry/camera.h"
#include "core/mesh/mesh_point.h"

namespace penpose::curve {

/// A stroke on the surface.
struct ProjectedStroke {
  std::vector<mesh::MeshPoint> points;
  std::vector<ModelPoint> positions;         ///< of the points, on the posed mesh
  std::vector<std::size_t> samples;          ///< sample of the stroke that each point came from, ascending
  std::vector<geometry::ModelVector> aside;  ///< from each point to the pen, at the point's depth; empty: no offset
  std::size_t dropped = 0;                   ///< samples that gave no point: they missed, or lay on a shorter run
};

/// Projects a stroke onto the mesh (method, section 1): the ray of every sample hits the closest visible face; samples
/// that miss are dropped; of several runs of hits the longest in px is kept. Samples in the same place give one point.
/// Error: fewer than two distinct hits ("the line does not touch the mesh").
[[nodiscard]] base::Result<ProjectedStroke> project_stroke(std::span<const PxPoint> stroke,
                                                           const geometry::Camera& camera,
                                                           const geometry::TriangleBvh& surface);

/// A reference curve: the stroke projected, reparameterised by arc length on the image plane to `count` points and
/// glued to the surface. A point between two hits that itself misses takes the nearer hit.
[[nodiscard]] base::Result<ProjectedStroke> surface_curve(std::span<const PxPoint> stroke, std::size_t count,
                                                          const geometry::Camera& camera,
                                                          const geometry::TriangleBvh& surface);

}  // namespace penpose::curve
