#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace penpose::io {

/// One normal of length one a vertex: the sum of the normals of its triangles, each as long as its triangle is large.
/// `groups` gives for every vertex the lowest-numbered one it shares the normal with. A vertex without area gets +z.
[[nodiscard]] std::vector<glm::vec3> smooth_normals(std::span<const mesh::ModelPoint> positions,
                                                    std::span<const mesh::Triangle> triangles,
                                                    std::span<const std::uint32_t> groups);

/// Gives normals to the vertices of the source whose normal is zero, and length one to the others. Vertices are not
/// joined. Precondition: one normal a vertex, triangles in range.
void fill_missing_normals(mesh::MeshSource& source);

}  // namespace penpose::io
