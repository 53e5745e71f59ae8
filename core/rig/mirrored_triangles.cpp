#include "core/rig/mirrored_triangles.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <utility>

namespace penpose::rig {

void turn_mirrored(const Skeleton& skeleton, std::span<mesh::Triangle> triangles) {
  const std::vector<double> rest(skeleton.parameters().size(), 0.0);
  std::vector<glm::dmat4> matrices(skeleton.joints().size());
  skeleton.joint_matrices(rest, matrices);
  const auto mirrors = [](const glm::dmat4& matrix) { return glm::determinant(glm::dmat3(matrix)) < 0.0; };
  if (std::none_of(matrices.begin(), matrices.end(), mirrors)) return;
  for (mesh::Triangle& triangle : triangles) {
    if (triangle[0] < skeleton.vertex_count() && mirrors(skeleton.vertex_matrix(triangle[0], matrices)))
      std::swap(triangle[1], triangle[2]);
  }
}

}  // namespace penpose::rig
