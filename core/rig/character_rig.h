#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"
#include "core/rig/displacement_layer.h"
#include "core/rig/skeleton.h"

namespace penpose::rig {

/// The sum of rigs in glTF's order: rest vertices, plus the displacements of all layers, carried by the skeleton (if
/// any). Parameters: those of the layers in order, then those of the skeleton.
class CharacterRig final : public Rig {
 public:
  /// Errors: a skeleton for another number of vertices, two parameters of one name (place "parameter NAME").
  static base::Result<std::shared_ptr<const CharacterRig>> make(
      std::shared_ptr<const mesh::TriangleMesh> mesh, std::vector<std::shared_ptr<const DisplacementLayer>> layers,
      std::shared_ptr<const Skeleton> skeleton);

  [[nodiscard]] std::span<const Parameter> parameters() const override { return parameters_; }
  [[nodiscard]] std::size_t vertex_count() const override { return mesh_->vertex_count(); }
  void evaluate(std::span<const double> pose, std::span<ModelPoint> positions) const override;
  /// The rest vertices and what the layers add, before the skeleton carries them.
  void displace(std::span<const double> pose, std::span<ModelPoint> positions) const;
  [[nodiscard]] std::unique_ptr<BoundVertices> bind(std::span<const std::uint32_t> vertices) const override;

  [[nodiscard]] const mesh::TriangleMesh& mesh() const { return *mesh_; }
  [[nodiscard]] std::span<const std::shared_ptr<const DisplacementLayer>> layers() const { return layers_; }
  [[nodiscard]] const Skeleton* skeleton() const { return skeleton_.get(); }
  /// The first parameter of layer i; of the skeleton where i is the number of layers.
  [[nodiscard]] std::size_t first_parameter(std::size_t layer) const { return first_parameter_[layer]; }

 private:
  std::shared_ptr<const mesh::TriangleMesh> mesh_;
  std::vector<std::shared_ptr<const DisplacementLayer>> layers_;
  std::shared_ptr<const Skeleton> skeleton_;
  std::vector<std::size_t> first_parameter_;
  std::vector<Parameter> parameters_;
};

}  // namespace penpose::rig
