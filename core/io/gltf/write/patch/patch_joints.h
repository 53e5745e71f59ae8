#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>

#include "core/io/gltf/write/patch/patch_state.h"

namespace penpose::io {

/// Whether a skeleton is that of the file and one joint more, at the origin, for all vertices that none carried: a head
/// that moves as a whole (document::with_placements).
[[nodiscard]] bool carries_the_rest(const rig::Skeleton& now, const rig::Skeleton* was);

/// Gives the joints of a file the rotations of the pose. Those of a VRM avatar stay at rest, which is its T-pose for
/// whoever loads it (VRMC_vrm 1.0, humanoid); its pose stands in penpose's own extras alone.
class PatchJoints {
 public:
  explicit PatchJoints(PatchState& state);

  /// A node above all parts that no joint carried.
  void write_carrier();
  void write_pose();
  /// Whether joints are posed, and other programs do not see it in the file.
  [[nodiscard]] bool pose_is_apart() const { return apart_; }
  /// The node that stands for a joint of the model.
  [[nodiscard]] std::optional<std::size_t> node_of(std::size_t joint) const {
    return joint < state_.source.nodes.size() ? state_.source.nodes[joint] : carrier_;
  }

 private:
  void write_joint(const rig::Joint& joint, const glm::dvec3& angles, json::Json& node);
  void put_to_rest();
  void carry_alone(MeshTargets& mesh, std::optional<std::size_t> parent);

  PatchState& state_;
  bool stay_at_rest_;
  bool apart_ = false;
  std::optional<std::size_t> carrier_;  ///< the node that carries what no joint of the file does
};

}  // namespace penpose::io
