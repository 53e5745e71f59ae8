#pragma once

#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <set>
#include <vector>

#include "core/document/humanoid.h"
#include "core/document/humanoid_rest.h"
#include "core/document/model.h"
#include "core/io/gltf/write/vrma/vrma_builder.h"

namespace penpose::io {

/// What a VRM animation says of bones: the figure in T-pose, their turns, the way of the hips, the gaze. All that is
/// given outlives it.
class VrmaBones {
 public:
  using HumanBone = document::HumanBone;

  /// `animation`: null: the pose is written.
  VrmaBones(const document::Model& model, const document::Animation* animation, VrmaBuilder& file);

  void write();
  /// Notes how many animated joints are no bones.
  void note_left_out();

 private:
  /// The nearest bone above that the model has.
  [[nodiscard]] std::optional<HumanBone> above(HumanBone bone) const;
  /// The figure in T-pose. Bones that the format wants and the model lacks stand still where the bone above them is.
  void place_bones();
  [[nodiscard]] glm::dquat local_rotation(std::size_t joint, double time_s) const;
  /// The joints from a bone up to the bone above it, or to the root.
  [[nodiscard]] std::vector<std::size_t> path_of(HumanBone bone) const;
  void add_quaternion(const glm::dquat& q, bool direction, std::vector<float>& values) const;
  /// The normalised rotation of a bone at a time: N = P q inverse(W), where joints between it and the bone above turn
  /// too; P is the rotation of the bone above, or of the joint above the whole path, at rest.
  [[nodiscard]] glm::dquat normalised(const std::vector<std::size_t>& path, double time_s) const;
  /// Keys of the normalised rotation; empty where the bone stays at rest.
  struct Turns {
    std::vector<double> times_s;
    document::Interpolation interpolation = document::Interpolation::linear;
    std::vector<float> values;
  };
  [[nodiscard]] Turns turns_of(HumanBone bone);
  void turn_bone(HumanBone bone);
  void move_hips();
  void turn_gaze();

  const document::Model& model_;
  const document::Animation* animation_;
  document::Humanoid humanoid_;
  glm::dquat to_front_;  ///< from where the model looks to +z
  std::vector<document::RestJoint> rest_;
  std::vector<glm::dquat> pose_of_;                  ///< local rotations in the model's pose
  std::vector<const document::Channel*> turns_;      ///< one a joint, or null
  std::vector<const document::Channel*> shifts_;     ///< the same
  std::set<std::size_t> used_;                       ///< joints whose turn is part of a bone's
  std::vector<std::optional<std::size_t>> node_of_;  ///< one a bone
  VrmaBuilder& file_;
};

}  // namespace penpose::io
