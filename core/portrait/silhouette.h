#pragma once

#include <span>
#include <vector>

#include "core/geometry/bvh.h"
#include "core/geometry/camera.h"
#include "core/mesh/triangle_mesh.h"
#include "core/posing/problem.h"

namespace penpose::portrait {

/// A line of the surface, in order; a closed one ends with the point that it begins with.
using SurfaceLine = std::vector<posing::CurvePoint>;

/// Where a point of the surface is. `positions`: of all vertices.
[[nodiscard]] geometry::ModelPoint place_of(const posing::CurvePoint& point,
                                            std::span<const geometry::ModelPoint> positions);

/// The place a share of the way from one point of a line of the surface to the next. Precondition: both lie in one
/// triangle, so that they name three vertices at most.
[[nodiscard]] posing::CurvePoint point_between(const posing::CurvePoint& from, const posing::CurvePoint& to,
                                               double share);

/// The parts of a line of the surface that are not behind other parts of it, in order, each of at least two points.
/// `positions`: of all vertices, as posed, in which the camera and the tree see the mesh too.
[[nodiscard]] std::vector<SurfaceLine> seen_parts(const geometry::Camera& camera, const SurfaceLine& line,
                                                  std::span<const geometry::ModelPoint> positions,
                                                  const geometry::TriangleBvh& tree);

/// The contours that a camera sees: where the surface turns away from it, across triangles (Hertzmann and Zorin,
/// "Illustrating smooth surfaces", 2000: where the vertices' normals are at right angles to the view), chained, without
/// what lies behind other parts: each goes on to where something hides it, and one that nothing hides is closed. The
/// longest in the picture first, each with the surface on the same side of its way. `positions`: of all vertices, as
/// posed, in which the camera and the tree see the mesh too. `least_px`: shorter ones are left out.
[[nodiscard]] std::vector<SurfaceLine> silhouette(const geometry::Camera& camera, const mesh::TriangleMesh& mesh,
                                                  std::span<const geometry::ModelPoint> positions,
                                                  const geometry::TriangleBvh& tree, double least_px = 0);

}  // namespace penpose::portrait
