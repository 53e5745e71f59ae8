#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace penpose::render {

/// Normals of unit length for a posed mesh, one a vertex: the triangles' normals weighted by area, summed over the
/// vertices that share a smooth normal (mesh.smoothing()). A vertex without area gets +Z. Works at any scale.
/// Precondition: one position a vertex.
[[nodiscard]] std::vector<glm::vec3> smooth_normals(const mesh::TriangleMesh& mesh,
                                                    std::span<const glm::vec3> positions);

/// Model points in the precision that the graphics card takes.
[[nodiscard]] std::vector<glm::vec3> to_float(std::span<const geometry::ModelPoint> points);

}  // namespace penpose::render
