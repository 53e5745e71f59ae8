#include "core/intent/model/control_effects.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penpose::intent {

ControlEffects::ControlEffects(const rig::Rig& rig)
    : rig_(rig), pose_(rig::rest_pose(rig)), rest_(rig.vertex_count()), moved_(rig.vertex_count()) {
  for (std::uint32_t v = 0; v < rest_.size(); ++v) all_.push_back(v);
  rig.evaluate(pose_, rest_);
  const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig);
  // A vertex that is no number at rest is none wherever joints turn: it is an effect of every control.
  const bool finite =
      std::all_of(rest_.begin(), rest_.end(), [](const ModelPoint& p) { return std::isfinite(p.x + p.y + p.z); });
  if (character == nullptr || character->skeleton() == nullptr || !finite) return;
  skeleton_ = character->skeleton();
  first_angle_ = character->first_parameter(character->layers().size());
  followers_.emplace(*character);
}

ControlEffect ControlEffects::of(std::size_t parameter, double value) {
  if (!followers_ || parameter < first_angle_ || !followers_->are_all(parameter - first_angle_)) {
    const double at_rest = std::exchange(pose_[parameter], value);
    rig_.evaluate(pose_, moved_);
    pose_[parameter] = at_rest;
    return {all_, rest_, moved_};
  }
  const std::size_t angle = parameter - first_angle_;
  const std::uint32_t joint = skeleton_->joint_of(angle);
  if (joint_ != joint) {
    joint_ = joint;
    following_ = followers_->of(joint);
    following_rest_.clear();
    for (const std::uint32_t v : following_) following_rest_.push_back(rest_[v]);
  }
  const std::span places = std::span(moved_).first(following_.size());
  followers_->turn(angle, value, places);
  return {following_, following_rest_, places};
}

}  // namespace penpose::intent
