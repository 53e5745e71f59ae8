#include "core/io/gltf/write/deformer_sample.h"

namespace penpose::io {

rig::BlendShape sample_deformer(const articulation::Deformer& deformer) {
  rig::BlendShape shape;
  shape.parameter = deformer.parameter();
  const auto vertices = deformer.vertices();
  shape.vertices.assign(vertices.begin(), vertices.end());
  for (const geometry::ModelVector& move : deformer.displacements(1.0)) shape.deltas.emplace_back(move);
  return shape;
}

bool is_sample_of(const rig::BlendShape& target, const articulation::Deformer& deformer, double tolerance) {
  const rig::BlendShape sample = sample_deformer(deformer);
  // Either list may leave out vertices that do not move.
  std::size_t a = 0;
  std::size_t b = 0;
  while (a < target.vertices.size() || b < sample.vertices.size()) {
    const bool in_a =
        a < target.vertices.size() && (b == sample.vertices.size() || target.vertices[a] <= sample.vertices[b]);
    const bool in_b =
        b < sample.vertices.size() && (a == target.vertices.size() || sample.vertices[b] <= target.vertices[a]);
    const glm::vec3 apart = (in_a ? target.deltas[a] : glm::vec3(0)) - (in_b ? sample.deltas[b] : glm::vec3(0));
    if (!(geometry::length(geometry::ModelVector(apart)) <= tolerance)) return false;
    a += in_a ? 1 : 0;
    b += in_b ? 1 : 0;
  }
  return true;
}

}  // namespace penpose::io
