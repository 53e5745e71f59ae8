#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::document {

/// A joint's transform relative to its parent.
struct JointTransform {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
};

/// An animation at one time.
struct AnimationSample {
  std::vector<double>
      weights;  ///< one a blend shape and then one a sketched deformer, or empty where the animation drives none
  std::vector<JointTransform> joints;  ///< one a joint of the skeleton; at rest where the animation drives none
};

/// Time of the last key, seconds; 0 for an animation without keys.
[[nodiscard]] double duration_s(const Animation& animation);

/// The numbers of one channel at a time, `width` of them (weights: the number of blend shapes; rotation 4; else 3), by
/// glTF 2.0, appendix C: held before the first and after the last key; step, linear (rotations: spherical linear by
/// the shorter way) or cubic Hermite with tangents a second (rotations normalised). Empty when the channel's arrays do
/// not fit each other.
[[nodiscard]] std::vector<double> sample_channel(const Channel& channel, std::size_t width, double time_s);

/// The animation at a time. Channels that do not fit the model (a joint that does not exist, arrays of other lengths)
/// are left out.
[[nodiscard]] AnimationSample sample(const Model& model, const Animation& animation, double time_s);

/// The model at that time: the weights become the pose (clamped to the parameters' ranges), and the sample's joint
/// transforms become the rest pose of its joints, so that joint parameters turn relative to them. Errors of the rig.
[[nodiscard]] base::Result<Model> model_at(const Model& model, const AnimationSample& moment);

}  // namespace penpose::document
