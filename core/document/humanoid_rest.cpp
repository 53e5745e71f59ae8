#include "core/document/humanoid_rest.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rotation.h"

namespace penpose::document {

glm::dquat unit_rotation(const glm::dquat& q) {
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return size > 1e-12 ? glm::dquat(q.w / size, q.x / size, q.y / size, q.z / size) : glm::dquat(1, 0, 0, 0);
}

std::vector<RestJoint> rest_joints(std::span<const rig::Joint> joints) {
  std::vector<RestJoint> all(joints.size());
  std::vector<glm::dmat4> matrices(joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    RestJoint& rest = all[i];
    if (joints[i].parent >= 0) {
      const auto parent = static_cast<std::size_t>(joints[i].parent);
      rest.parent_rotation = all[parent].rotation;
      rest.parent_matrix = matrices[parent];
    }
    rest.rotation = unit_rotation(rest.parent_rotation * unit_rotation(joints[i].rest_rotation));
    matrices[i] =
        rest.parent_matrix * geometry::compose(joints[i].translation, joints[i].rest_rotation, joints[i].scale);
    rest.position = geometry::ModelPoint(matrices[i][3]);
  }
  return all;
}

Humanoid humanoid_of(const Model& model) {
  if (!model.skeleton) return {};
  const auto joints = model.skeleton->joints();
  const auto& said = model.humanoid.joint_of;
  // A table of another skeleton says nothing.
  const bool fits = std::all_of(said.begin(), said.end(),
                                [&](std::int32_t joint) { return joint < static_cast<std::int32_t>(joints.size()); });
  return fits && !model.humanoid.empty() ? model.humanoid : humanoid_by_names(joints);
}

}  // namespace penpose::document
