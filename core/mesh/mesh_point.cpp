#include "core/mesh/mesh_point.h"

#include <algorithm>

namespace penpose::mesh {

ModelPoint position_of(const MeshPoint& point, std::span<const Triangle> triangles,
                       std::span<const ModelPoint> positions) {
  const Triangle& corner = triangles[point.triangle];
  return positions[corner[0]] * point.barycentric[0] + positions[corner[1]] * point.barycentric[1] +
         positions[corner[2]] * point.barycentric[2];
}

std::optional<MeshPoint> mesh_point_at(std::uint32_t vertex, std::span<const Triangle> triangles) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto corner = std::find(triangles[t].begin(), triangles[t].end(), vertex);
    if (corner == triangles[t].end()) continue;
    MeshPoint point{t, {0, 0, 0}};
    point.barycentric[static_cast<std::size_t>(corner - triangles[t].begin())] = 1;
    return point;
  }
  return std::nullopt;
}

}  // namespace penpose::mesh
