#include "core/mesh/mesh_point.h"

namespace penpose::mesh {

ModelPoint position_of(const MeshPoint& point, std::span<const Triangle> triangles,
                       std::span<const ModelPoint> positions) {
  const Triangle& corner = triangles[point.triangle];
  return positions[corner[0]] * point.barycentric[0] + positions[corner[1]] * point.barycentric[1] +
         positions[corner[2]] * point.barycentric[2];
}

}  // namespace penpose::mesh
