#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document/model.h"
#include "core/rig/rig.h"

namespace penpose::document {

/// An immutable pose, shared by all copies: undo keeps many timelines that differ by one key.
class SharedPose {
 public:
  SharedPose() : SharedPose(rig::Pose()) {}
  SharedPose(rig::Pose pose)  // NOLINT(google-explicit-constructor): a pose is one
      : pose_(std::make_shared<const rig::Pose>(std::move(pose))) {}

  operator const rig::Pose&() const { return *pose_; }  // NOLINT(google-explicit-constructor)
  [[nodiscard]] double operator[](std::size_t parameter) const { return (*pose_)[parameter]; }
  [[nodiscard]] std::size_t size() const { return pose_->size(); }
  [[nodiscard]] auto begin() const { return pose_->begin(); }
  [[nodiscard]] auto end() const { return pose_->end(); }
  friend bool operator==(const SharedPose& a, const SharedPose& b) {
    return a.pose_ == b.pose_ || *a.pose_ == *b.pose_;
  }

 private:
  std::shared_ptr<const rig::Pose> pose_;
};

/// A pose at a time.
struct PoseKey {
  double time_s = 0;
  SharedPose pose;   ///< one value a parameter of the rig
  std::string name;  ///< of the pose, or empty
  friend bool operator==(const PoseKey&, const PoseKey&) = default;
};

/// Interpolation between keys.
enum class KeyInterpolation : std::uint8_t {
  linear,
  smooth,  ///< cubic Hermite whose tangents never overshoot the keys (Fritsch and Carlson 1980)
};

/// Key poses, ascending in time, no two at the same time.
struct Timeline {
  KeyInterpolation interpolation = KeyInterpolation::smooth;
  std::vector<PoseKey> keys;
  friend bool operator==(const Timeline&, const Timeline&) = default;
};

/// The latest time of a key, seconds.
inline constexpr double k_latest_key_s = 36000;

/// The pose at a time, held before the first and after the last key. Precondition: there is a key.
[[nodiscard]] rig::Pose sample(const Timeline& timeline, double time_s);

/// The slope at every key of one parameter's curve, in units a second, for `smooth`.
[[nodiscard]] std::vector<double> monotone_tangents(std::span<const double> times_s, std::span<const double> values);

/// The timeline as an animation that any viewer can play: weights of shapes and deformers exactly, joints sampled
/// `joint_samples_per_s` times a second between their keys. Empty for a timeline without keys.
[[nodiscard]] Animation to_animation(const Model& model, const Timeline& timeline, double joint_samples_per_s = 60);

}  // namespace penpose::document
