#include "core/rig/skeleton.h"

#include <cmath>

#include "core/geometry/rotation.h"

namespace penpose::rig {
namespace {

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::optional<base::Error> check_joint(const Joint& joint, std::size_t index) {
  const std::string place = "joint " + std::to_string(index) + (joint.name.empty() ? "" : " (" + joint.name + ")");
  if (joint.parent < -1 || joint.parent >= static_cast<std::int64_t>(index)) {
    return base::Error{"does not come after its parent", place, "list parents before their children"};
  }
  const glm::dquat& q = joint.rest_rotation;
  bool good = finite(joint.translation) && finite(joint.scale) && finite({q.x, q.y, q.z}) && std::isfinite(q.w);
  for (int c = 0; c < 4; ++c)
    good = good && finite(glm::dvec3(joint.inverse_bind[c])) && std::isfinite(joint.inverse_bind[c][3]);
  if (!good) return base::Error{"has a number that is not finite", place, "export the model again"};
  for (int axis = 0; axis < 3; ++axis) {
    if (!(joint.minimum[axis] <= 0.0 && joint.maximum[axis] >= 0.0 && joint.minimum[axis] < joint.maximum[axis])) {
      return base::Error{"has a range without room for its rest value 0", place, "give minimum <= 0 <= maximum"};
    }
  }
  return std::nullopt;
}

}  // namespace

base::Result<std::shared_ptr<const Skeleton>> Skeleton::make(std::vector<Joint> joints,
                                                             std::vector<std::uint32_t> first_influence,
                                                             std::vector<Influence> influences) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (auto error = check_joint(joints[i], i)) return *error;
  }
  if (first_influence.empty() || first_influence.front() != 0 || first_influence.back() != influences.size()) {
    return base::Error{"the influences do not fit the vertices", "", "export the model again"};
  }
  for (std::size_t v = 0; v + 1 < first_influence.size(); ++v) {
    const std::string place = "vertex " + std::to_string(v);
    if (first_influence[v] > first_influence[v + 1] || first_influence[v + 1] > influences.size())
      return base::Error{"the influences are out of order", place, "export the model again"};
    double sum = 0;
    for (std::uint32_t k = first_influence[v]; k < first_influence[v + 1]; ++k) {
      if (influences[k].joint >= joints.size())
        return base::Error{"a joint does not exist", place, "export the model again"};
      if (!(influences[k].weight >= 0.0) || !std::isfinite(influences[k].weight)) {
        return base::Error{"a skin weight is negative or no number", place,
                           "export the model again with valid weights"};
      }
      sum += influences[k].weight;
    }
    if (first_influence[v] == first_influence[v + 1]) continue;
    if (!(sum > 0.0))
      return base::Error{"all skin weights are zero", place, "export the model again with valid weights"};
    // Weights that already sum to one within their float precision stay as they are, bit for bit.
    if (std::abs(sum - 1.0) < 1e-6) continue;
    for (std::uint32_t k = first_influence[v]; k < first_influence[v + 1]; ++k) influences[k].weight /= sum;
  }
  auto made = std::make_shared<Skeleton>();
  for (std::uint32_t i = 0; i < joints.size(); ++i) {
    if (!joints[i].posable) continue;
    made->posable_.push_back(i);
    const std::string name = joints[i].name.empty() ? "joint" + std::to_string(i) : joints[i].name;
    constexpr std::array<const char*, 3> k_axes = {".rx", ".ry", ".rz"};
    for (int axis = 0; axis < 3; ++axis) {
      made->parameters_.push_back(
          {name + k_axes[static_cast<std::size_t>(axis)], 0, joints[i].minimum[axis], joints[i].maximum[axis]});
    }
  }
  made->joints_ = std::move(joints);
  made->first_influence_ = std::move(first_influence);
  made->influences_ = std::move(influences);
  return std::shared_ptr<const Skeleton>(std::move(made));
}

std::span<const Influence> Skeleton::influences_of(std::uint32_t vertex) const {
  return std::span(influences_)
      .subspan(first_influence_[vertex], first_influence_[vertex + 1] - first_influence_[vertex]);
}

void Skeleton::joint_matrices(std::span<const double> values, std::span<glm::dmat4> matrices) const {
  std::size_t next = 0;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    glm::dquat rotation = joint.rest_rotation;
    if (joint.posable) {
      const glm::dvec3 angles{values[next], values[next + 1], values[next + 2]};
      next += 3;
      if (angles != glm::dvec3{0}) rotation = rotation * geometry::quaternion_from_xyz(angles);
    }
    const glm::dmat4 local = geometry::compose(joint.translation, rotation, joint.scale);
    matrices[i] = joint.parent < 0 ? local : matrices[static_cast<std::size_t>(joint.parent)] * local;
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) matrices[i] = matrices[i] * joints_[i].inverse_bind;
}

glm::dmat4 Skeleton::vertex_matrix(std::uint32_t vertex, std::span<const glm::dmat4> matrices) const {
  const auto influences = influences_of(vertex);
  if (influences.empty()) return glm::dmat4(1);
  if (influences.size() == 1) return matrices[influences[0].joint];
  glm::dmat4 sum(0);
  for (const Influence& influence : influences) sum += matrices[influence.joint] * influence.weight;
  return sum;
}

}  // namespace penpose::rig
