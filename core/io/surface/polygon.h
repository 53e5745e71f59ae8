#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace penpose::io {

/// Cuts a polygon of at least 3 corners into triangles with its winding and adds them to `out`. A convex quad is cut
/// along its shorter diagonal; other polygons by cutting off ears in the plane of their area vector (Meisters 1975), so
/// that flat concave ones stay right; what has no ear left becomes a fan. Precondition: the corners exist.
void triangulate(std::span<const std::uint32_t> corners, std::span<const mesh::ModelPoint> positions,
                 std::vector<mesh::Triangle>& out);

}  // namespace penpose::io
