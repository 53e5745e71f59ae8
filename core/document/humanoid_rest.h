#pragma once

#include <span>
#include <vector>

#include "core/document/humanoid.h"
#include "core/document/model.h"

namespace penpose::document {

/// The quaternion with a length of one; no rotation for one of no length.
[[nodiscard]] glm::dquat unit_rotation(const glm::dquat& q);

/// Where a joint stands in the world at rest.
struct RestJoint {
  glm::dquat rotation{1, 0, 0, 0};         ///< without scales, of length one
  glm::dquat parent_rotation{1, 0, 0, 0};  ///< that of its parent
  glm::dmat4 parent_matrix{1};             ///< from the parent's space, with scales
  geometry::ModelPoint position{0};
};
/// One a joint.
[[nodiscard]] std::vector<RestJoint> rest_joints(std::span<const rig::Joint> joints);

/// The humanoid of a model: as its file says it, else by the names of its joints. Empty without a skeleton.
[[nodiscard]] Humanoid humanoid_of(const Model& model);

}  // namespace penpose::document
