#include "core/articulation/region/canvas.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <string>

namespace penpose::articulation {

base::Result<std::shared_ptr<const Canvas>> Canvas::make(std::shared_ptr<const mesh::TriangleMesh> mesh,
                                                         const rig::Skeleton* skeleton) {
  return make_posed(std::move(mesh), skeleton, {});
}

base::Result<std::shared_ptr<const Canvas>> Canvas::make_posed(std::shared_ptr<const mesh::TriangleMesh> mesh,
                                                               const rig::Skeleton* skeleton,
                                                               std::span<const ModelVector> displacements) {
  auto canvas = std::make_shared<Canvas>();
  std::vector<ModelPoint> rest(mesh->positions().begin(), mesh->positions().end());
  for (std::size_t v = 0; v < displacements.size(); ++v) rest[v] += displacements[v];
  canvas->positions_ = rest;
  canvas->mesh_ = std::move(mesh);
  if (skeleton == nullptr) return std::shared_ptr<const Canvas>(std::move(canvas));
  if (skeleton->vertex_count() != rest.size()) {
    return base::Error{"the skeleton is for another number of vertices", "", "bind the skeleton to this mesh"};
  }
  std::vector<double> values;
  for (const rig::Parameter& parameter : skeleton->parameters()) values.push_back(parameter.rest);
  std::vector<glm::dmat4> joints(skeleton->joints().size());
  skeleton->joint_matrices(values, joints);
  for (std::uint32_t v = 0; v < rest.size(); ++v) {
    const glm::dmat4 carrier = skeleton->vertex_matrix(v, joints);
    canvas->positions_[v] = ModelPoint(carrier * glm::dvec4(rest[v], 1.0));
    canvas->carriers_.emplace_back(carrier);
  }
  return std::shared_ptr<const Canvas>(std::move(canvas));
}

base::Result<glm::dmat3> Canvas::to_rest(std::uint32_t vertex) const {
  if (carriers_.empty()) return glm::dmat3(1);
  const glm::dmat3& carrier = carriers_[vertex];
  const double size = geometry::length(carrier[0]) * geometry::length(carrier[1]) * geometry::length(carrier[2]);
  const double volume = glm::determinant(carrier);
  if (!(std::abs(volume) > 1e-9 * size)) {
    return base::Error{"the joints of the vertex flatten it, so that it cannot be moved freely",
                       "vertex " + std::to_string(vertex), "give its joints a scale other than 0"};
  }
  return glm::inverse(carrier);
}

}  // namespace penpose::articulation
