#include "core/document/time/animation_poses.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

#include "core/document/time/animation_sampling.h"
#include "core/geometry/rotation.h"

namespace penpose::document {
namespace {

void set_joints(const Model& model, const std::vector<JointTransform>& joints, rig::Pose& pose) {
  const std::size_t first = weight_count(model);
  for (std::size_t p = 0; p < model.skeleton->parameters().size(); p += 3) {
    const std::uint32_t number = model.skeleton->joint_of(p);
    const rig::Joint& joint = model.skeleton->joints()[number];
    const glm::dvec3 angles =
        geometry::xyz_from_quaternion(glm::conjugate(joint.rest_rotation) * joints[number].rotation);
    for (int axis = 0; axis < 3; ++axis) pose[first + p + static_cast<std::size_t>(axis)] = angles[axis];
  }
}

}  // namespace

std::vector<double> moments_of(const Animation& animation) {
  std::vector<double> times;
  for (const Channel& channel : animation.channels) {
    if (channel.target != ChannelTarget::weights && channel.target != ChannelTarget::rotation) continue;
    times.insert(times.end(), channel.times_s.begin(), channel.times_s.end());
  }
  std::stable_sort(times.begin(), times.end());
  std::vector<double> out;
  for (const double time : times) {
    if (out.empty() || time - out.back() > k_same_moment_s) out.push_back(time);
  }
  return out;
}

std::vector<PoseKey> poses_at(const Model& model, const Animation& animation, std::span<const double> times_s) {
  const auto parameters = model.rig->parameters();
  std::vector<PoseKey> keys;
  for (const double time_s : times_s) {
    const AnimationSample moment = sample(model, animation, time_s);
    rig::Pose pose = rig::rest_pose(*model.rig);
    std::copy(moment.weights.begin(), moment.weights.end(), pose.begin());
    if (model.skeleton) set_joints(model, moment.joints, pose);
    for (std::size_t i = 0; i < pose.size(); ++i) {
      pose[i] = std::clamp(pose[i], parameters[i].minimum, parameters[i].maximum);
    }
    keys.push_back({time_s, std::move(pose), {}});
  }
  return keys;
}

}  // namespace penpose::document
