#include "core/io/gltf/write/vrma/vrma_bones.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/base/math.h"
#include "core/document/time/animation_sampling.h"
#include "core/geometry/rotation.h"

namespace penpose::io {
namespace {

using document::Channel;
using document::ChannelTarget;
using document::HumanBone;
using document::Interpolation;

/// Whether the format has it at all: eyes are the gaze (VRMC_vrm_animation, schema of humanBones).
bool is_eye(HumanBone bone) { return bone == HumanBone::left_eye || bone == HumanBone::right_eye; }

/// The format wants these (the same schema).
bool is_required(HumanBone bone) {
  using enum HumanBone;
  constexpr std::array k_required{hips,
                                  spine,
                                  head,
                                  left_upper_leg,
                                  left_lower_leg,
                                  left_foot,
                                  right_upper_leg,
                                  right_lower_leg,
                                  right_foot,
                                  left_upper_arm,
                                  left_lower_arm,
                                  left_hand,
                                  right_upper_arm,
                                  right_lower_arm,
                                  right_hand};
  return std::find(k_required.begin(), k_required.end(), bone) != k_required.end();
}

}  // namespace

VrmaBones::VrmaBones(const document::Model& model, const document::Animation* animation, VrmaBuilder& file)
    : model_(model),
      animation_(animation),
      humanoid_(document::humanoid_of(model)),
      to_front_(geometry::quaternion_from_xyz({0, -base::radians(model.front_yaw_degrees), 0})),
      file_(file) {
  if (!model.skeleton) return;
  rest_ = document::rest_joints(model.skeleton->joints());
  std::size_t parameter = document::weight_count(model);
  for (const rig::Joint& joint : model.skeleton->joints()) {
    pose_of_.push_back(joint.rest_rotation);
    if (!joint.posable) continue;
    const double* angles = &model.pose[parameter];
    pose_of_.back() = joint.rest_rotation * geometry::quaternion_from_xyz({angles[0], angles[1], angles[2]});
    parameter += 3;
  }
  turns_.resize(rest_.size());
  shifts_.resize(rest_.size());
  for (std::size_t c = 0; animation_ != nullptr && c < animation_->channels.size(); ++c) {
    const Channel& channel = animation_->channels[c];
    if (channel.joint >= rest_.size() || channel.times_s.empty()) continue;
    if (channel.target == ChannelTarget::rotation) turns_[channel.joint] = &channel;
    if (channel.target == ChannelTarget::translation) shifts_[channel.joint] = &channel;
  }
}

void VrmaBones::write() {
  place_bones();
  for (std::size_t b = 0; b < document::k_human_bones; ++b) turn_bone(static_cast<HumanBone>(b));
  move_hips();
  turn_gaze();
}

std::optional<HumanBone> VrmaBones::above(HumanBone bone) const {
  auto up = document::parent_of(bone);
  while (up && !humanoid_.joint(*up)) up = document::parent_of(*up);
  return up;
}

void VrmaBones::place_bones() {
  node_of_.assign(document::k_human_bones, std::nullopt);
  if (humanoid_.empty()) return;
  std::vector<glm::dvec3> places(document::k_human_bones, glm::dvec3(0));
  json::Json bones = json::Json::object();
  for (std::size_t b = 0; b < document::k_human_bones; ++b) {
    const auto bone = static_cast<HumanBone>(b);
    const auto joint = humanoid_.joint(bone);
    if (is_eye(bone) || (!joint && !is_required(bone))) continue;
    auto parent = document::parent_of(bone);
    while (parent && !node_of_[static_cast<std::size_t>(*parent)]) parent = document::parent_of(*parent);
    const glm::dvec3 above = parent ? places[static_cast<std::size_t>(*parent)] : glm::dvec3(0);
    places[b] = joint ? to_front_ * rest_[*joint].position : above;
    node_of_[b] = file_.add_node(std::string(document::name_of(bone)), places[b] - above,
                                 parent ? node_of_[static_cast<std::size_t>(*parent)] : std::nullopt);
    bones[std::string(document::name_of(bone))] = {{"node", *node_of_[b]}};
  }
  file_.own["humanoid"]["humanBones"] = std::move(bones);
}

glm::dquat VrmaBones::local_rotation(std::size_t joint, double time_s) const {
  if (turns_[joint] != nullptr) {
    const auto v = document::sample_channel(*turns_[joint], 4, time_s);
    if (v.size() == 4) return {v[3], v[0], v[1], v[2]};
  }
  return pose_of_[joint];
}

std::vector<std::size_t> VrmaBones::path_of(HumanBone bone) const {
  const auto parent = above(bone);
  const std::int32_t end = parent ? static_cast<std::int32_t>(*humanoid_.joint(*parent)) : -1;
  std::vector<std::size_t> path;
  for (auto j = static_cast<std::int32_t>(*humanoid_.joint(bone)); j >= 0 && j != end;
       j = model_.skeleton->joints()[static_cast<std::size_t>(j)].parent)
    path.push_back(static_cast<std::size_t>(j));
  return path;
}

void VrmaBones::add_quaternion(const glm::dquat& q, bool direction, std::vector<float>& values) const {
  glm::dquat turned = to_front_ * q * glm::conjugate(to_front_);
  // Neighbouring keys lie on the same side; tangents keep theirs.
  if (direction && values.size() >= 4) {
    const float* last = &values[values.size() - 4];
    const double dot = static_cast<double>(last[0]) * turned.x + static_cast<double>(last[1]) * turned.y +
                       static_cast<double>(last[2]) * turned.z + static_cast<double>(last[3]) * turned.w;
    if (dot < 0) turned = -turned;
  }
  for (const double part : {turned.x, turned.y, turned.z, turned.w}) values.push_back(static_cast<float>(part));
}

glm::dquat VrmaBones::normalised(const std::vector<std::size_t>& path, double time_s) const {
  glm::dquat turned = rest_[path.back()].parent_rotation;
  for (auto j = path.rbegin(); j != path.rend(); ++j) turned = turned * local_rotation(*j, time_s);
  return document::unit_rotation(turned * glm::conjugate(rest_[path.front()].rotation));
}

VrmaBones::Turns VrmaBones::turns_of(HumanBone bone) {
  Turns turns;
  const std::vector<std::size_t> path = path_of(bone);
  std::vector<const Channel*> moved;
  bool posed = false;
  for (const std::size_t j : path) {
    used_.insert(j);
    if (turns_[j] != nullptr) moved.push_back(turns_[j]);
    posed = posed || (turns_[j] == nullptr && pose_of_[j] != model_.skeleton->joints()[j].rest_rotation);
  }
  if (moved.empty() && !posed) return turns;
  const bool alone = path.size() == 1 && moved.size() == 1;
  if (!alone) {
    turns.times_s = moved.empty() ? std::vector<double>{0.0} : key_times(moved);
    for (const double time : turns.times_s) add_quaternion(normalised(path, time), true, turns.values);
    return turns;
  }
  // Linear in the quaternion, so that keys and tangents stay keys and tangents.
  const Channel& from = *moved.front();
  const bool cubic = from.interpolation == Interpolation::cubic_spline;
  turns.interpolation = from.interpolation;
  turns.times_s = from.times_s;
  const document::RestJoint& rest = rest_[path.front()];
  for (std::size_t i = 0; i + 4 <= from.values.size(); i += 4) {
    const double* v = &from.values[i];
    add_quaternion(rest.parent_rotation * glm::dquat(v[3], v[0], v[1], v[2]) * glm::conjugate(rest.rotation), !cubic,
                   turns.values);
  }
  return turns;
}

void VrmaBones::turn_bone(HumanBone bone) {
  if (!humanoid_.joint(bone) || is_eye(bone)) return;
  const Turns turns = turns_of(bone);
  if (turns.times_s.empty()) return;
  file_.add_keys(turns.times_s, turns.interpolation, turns.values, "VEC4", *node_of_[static_cast<std::size_t>(bone)],
                 "rotation");
}

void VrmaBones::move_hips() {
  const auto joint = humanoid_.joint(HumanBone::hips);
  if (!joint) return;
  const std::vector<std::size_t> path = path_of(HumanBone::hips);
  std::vector<const Channel*> moved;
  for (const std::size_t j : path) {
    if (shifts_[j] != nullptr) moved.push_back(shifts_[j]);
    if (j != *joint && turns_[j] != nullptr) moved.push_back(turns_[j]);
  }
  if (moved.empty()) return;
  const std::vector<double> times = key_times(moved);
  std::vector<float> values;
  for (const double time : times) {
    glm::dvec3 place(0);
    for (const std::size_t j : path) {
      const rig::Joint& one = model_.skeleton->joints()[j];
      glm::dvec3 shift = one.translation;
      if (shifts_[j] != nullptr) {
        const auto v = document::sample_channel(*shifts_[j], 3, time);
        if (v.size() == 3) shift = {v[0], v[1], v[2]};
      }
      place = j == *joint ? shift : shift + local_rotation(j, time) * (one.scale * place);
    }
    place = to_front_ * place;
    for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(place[axis]));
  }
  const bool steps = std::all_of(moved.begin(), moved.end(),
                                 [](const Channel* one) { return one->interpolation == Interpolation::step; });
  file_.add_keys(times, steps ? Interpolation::step : Interpolation::linear, values, "VEC3",
                 *node_of_[static_cast<std::size_t>(HumanBone::hips)], "translation");
}

void VrmaBones::turn_gaze() {
  std::vector<HumanBone> eyes;
  std::vector<const Channel*> moved;
  bool posed = false;
  glm::dvec3 place(0);
  for (const HumanBone eye : {HumanBone::left_eye, HumanBone::right_eye}) {
    const auto joint = humanoid_.joint(eye);
    if (!joint) continue;
    eyes.push_back(eye);
    place += to_front_ * rest_[*joint].position;
    for (const std::size_t j : path_of(eye)) {
      used_.insert(j);
      if (turns_[j] != nullptr) moved.push_back(turns_[j]);
      posed = posed || (turns_[j] == nullptr && pose_of_[j] != model_.skeleton->joints()[j].rest_rotation);
    }
  }
  if (eyes.empty() || (moved.empty() && !posed)) return;
  const std::vector<double> times = moved.empty() ? std::vector<double>{0.0} : key_times(moved);
  std::vector<float> values;
  for (const double time : times) {
    glm::dquat mean(0, 0, 0, 0);
    for (const HumanBone eye : eyes) {
      const glm::dquat turn = normalised(path_of(eye), time);
      mean = mean + (turn.w < 0 ? -turn : turn);
    }
    add_quaternion(document::unit_rotation(mean), true, values);
  }
  place /= static_cast<double>(eyes.size());
  const auto head = humanoid_.joint(HumanBone::head);
  if (head) place -= to_front_ * rest_[*head].position;
  const std::size_t node = file_.add_node("lookAt", {0, 0, 0}, std::nullopt);
  file_.own["lookAt"] = {{"node", node}, {"offsetFromHeadBone", float_row(place)}};
  file_.add_keys(times, Interpolation::linear, values, "VEC4", node, "rotation");
}

void VrmaBones::note_left_out() {
  std::size_t count = 0;
  for (std::size_t j = 0; j < turns_.size(); ++j) {
    if (turns_[j] != nullptr && !used_.contains(j)) ++count;
  }
  if (count > 0) {
    file_.notes.push_back(std::to_string(count) + " animated joints are no bones of a human figure and are left out");
  }
}

}  // namespace penpose::io
