#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/space.h"
#include "core/mesh/triangle_mesh.h"
#include "core/rig/skeleton.h"

namespace penpose::articulation {

using geometry::ModelPoint;
using geometry::ModelVector;

/// The model at rest in world space, as strokes are drawn on it. Joints (and the nodes of rigid parts) transform rest
/// vertices to world space. A deformer moves world positions and takes its displacements back through the inverse,
/// because displacements act before joints.
class Canvas {
 public:
  /// Errors: a skeleton for another number of vertices.
  static base::Result<std::shared_ptr<const Canvas>> make(std::shared_ptr<const mesh::TriangleMesh> mesh,
                                                          const rig::Skeleton* skeleton);

  /// The model posed: vertices displaced from rest (one displacement a vertex), joints at rest.
  static base::Result<std::shared_ptr<const Canvas>> make_posed(std::shared_ptr<const mesh::TriangleMesh> mesh,
                                                                const rig::Skeleton* skeleton,
                                                                std::span<const ModelVector> displacements);

  [[nodiscard]] const mesh::TriangleMesh& mesh() const { return *mesh_; }
  /// World positions of all vertices, at rest or as posed.
  [[nodiscard]] std::span<const ModelPoint> positions() const { return positions_; }
  /// True when joints or nodes transform the vertices.
  [[nodiscard]] bool carried() const { return !carriers_.empty(); }
  /// From a displacement in world space to one of the rest vertex. Error (place "vertex N"): the vertex's joints
  /// flatten it.
  [[nodiscard]] base::Result<glm::dmat3> to_rest(std::uint32_t vertex) const;

 private:
  std::shared_ptr<const mesh::TriangleMesh> mesh_;
  std::vector<ModelPoint> positions_;
  std::vector<glm::dmat3> carriers_;  ///< one a vertex, or empty
};

}  // namespace penpose::articulation
