#include "core/rig/skeleton.h"

#include <algorithm>
#include <cmath>
#include <cstring>

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
    made->first_parameter_.push_back(static_cast<std::uint32_t>(made->parameters_.size()));
    made->rest_locals_.push_back(geometry::compose(joints[i].translation, joints[i].rest_rotation, joints[i].scale));
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

glm::dmat4 Skeleton::local_matrix(std::size_t joint, const glm::dvec3& angles) const {
  if (angles == glm::dvec3{0}) return rest_locals_[joint];
  const Joint& one = joints_[joint];
  return geometry::compose(one.translation, one.rest_rotation * geometry::quaternion_from_xyz(angles), one.scale);
}

void Skeleton::joint_matrices(std::span<const double> values, std::span<glm::dmat4> matrices) const {
  PosedJoints posed(*this, std::vector<bool>(joints_.size(), true));
  posed.turn(values);
  std::copy(posed.matrices().begin(), posed.matrices().end(), matrices.begin());
}

PosedJoints::PosedJoints(const Skeleton& skeleton, std::vector<bool> wanted)
    : skeleton_(skeleton),
      worlds_(skeleton.joints().size()),
      matrices_(skeleton.joints().size()),
      changed_(skeleton.joints().size()) {
  for (std::uint32_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i]) wanted_.push_back(i);
  }
}

void PosedJoints::turn(std::span<const double> values, std::span<const std::uint32_t> joints) {
  const bool anew = !made_;
  made_ = true;
  values_.resize(values.size());
  for (const std::uint32_t i : joints) {
    const Joint& joint = skeleton_.joints()[i];
    bool changed = anew;
    glm::dvec3 angles{0};
    if (joint.posable) {
      const std::size_t at = skeleton_.first_parameter_[i];
      angles = {values[at], values[at + 1], values[at + 2]};
      // By their bits: not even a zero may keep the sign of another pose.
      if (anew || std::memcmp(values.data() + at, values_.data() + at, 3 * sizeof(double)) != 0) {
        changed = true;
        std::copy_n(values.data() + at, 3, values_.data() + at);
      }
    }
    const bool has_parent = joint.parent >= 0;
    if (has_parent && changed_[static_cast<std::size_t>(joint.parent)]) changed = true;
    changed_[i] = changed;
    if (!changed) continue;
    const glm::dmat4 local = skeleton_.local_matrix(i, angles);
    worlds_[i] = has_parent ? worlds_[static_cast<std::size_t>(joint.parent)] * local : local;
    matrices_[i] = worlds_[i] * joint.inverse_bind;
  }
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
