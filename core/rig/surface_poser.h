#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/mesh/vertex_rings.h"
#include "core/rig/blend_shapes.h"
#include "core/rig/character_rig.h"

namespace penpose::rig {

/// The whole posed surface for showing and picking: world positions and unit normals in float, updated in place with
/// only what changed since the pose before. Deltas are added in the order of their parameters, so that the same pose
/// gives the same bits whatever came before it. A vertex without area around it gets +z. Positions agree with
/// Rig::evaluate to float precision. Holds the posed state: one for each view.
class SurfacePoser {
 public:
  explicit SurfacePoser(std::shared_ptr<const CharacterRig> rig);

  /// Moves the surface to a pose; true when anything changed. Precondition: one value a parameter.
  bool update(std::span<const double> pose);

  [[nodiscard]] std::span<const glm::vec3> positions() const { return {positions_.data(), vertex_count_}; }
  [[nodiscard]] std::span<const glm::vec3> normals() const { return {normals_.data(), vertex_count_}; }
  /// Grows by one with every update that changed something.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  /// Four vertices side by side, laid out as in memory: x0 y0 z0 x1 y1 z1 x2 y2 z2 x3 y3 z3.
  struct alignas(16) BlockDelta {
    std::array<float, 12> values;
  };

  void build_blocks(const BlendShapes& shapes);
  void build_neighbors();
  void update_blocks(std::span<const double> values);
  void update_everything(std::span<const double> pose);
  void update_normals_of(std::uint32_t first, std::uint32_t last);

  std::shared_ptr<const CharacterRig> rig_;
  mesh::VertexRings rings_;
  std::size_t vertex_count_;
  bool blend_only_;                   ///< blend shapes alone: the fast way; else the rig is evaluated as a whole
  std::vector<glm::vec3> positions_;  ///< padded to whole blocks and one more, so that four floats can be read anywhere
  std::vector<glm::vec3> normals_;
  std::vector<glm::vec3> rest_;
  std::vector<std::uint32_t> first_delta_;  ///< one a block and one past the end
  std::vector<std::uint32_t> delta_shape_;
  std::vector<BlockDelta> deltas_;
  std::vector<std::uint32_t> first_neighbor_;  ///< blocks that hold a corner of a ring of this block
  std::vector<std::uint32_t> neighbors_;
  std::vector<std::uint8_t> block_changed_;
  std::vector<std::uint64_t> block_shapes_;    ///< one bit a shape: which shapes move the block
  std::vector<std::uint64_t> changed_shapes_;  ///< one bit a shape: which weights this update changed
  std::vector<float> weights_;
  Pose pose_;
  std::vector<ModelPoint> scratch_;
  std::uint64_t revision_ = 0;
};

}  // namespace penpose::rig
