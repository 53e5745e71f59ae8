#include "core/document/time/animation_building.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rotation.h"

namespace penpose::document {
namespace {

double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

/// The frames that become keys, and when.
struct Keys {
  std::vector<std::size_t> frames;
  std::vector<double> times_s;
};

Keys make_keys(std::span<const double> times_s) {
  Keys keys;
  for (std::size_t f = 0; f < times_s.size(); ++f) {
    const double time = rounded(times_s[f] - times_s[0]);
    if (!keys.times_s.empty() && !(time > keys.times_s.back())) continue;
    keys.frames.push_back(f);
    keys.times_s.push_back(time);
  }
  return keys;
}

void add_quaternion(const glm::dquat& q, std::vector<double>& values) {
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  double sign = 1;
  // Neighbouring keys lie on the same side, so that a viewer that mixes numbers does not go round the long way.
  if (values.size() >= 4) {
    const double* last = &values[values.size() - 4];
    if (last[0] * q.x + last[1] * q.y + last[2] * q.z + last[3] * q.w < 0) sign = -1;
  }
  for (const double part : {q.x, q.y, q.z, q.w}) values.push_back(rounded(sign * part / size));
}

void add_vector(const glm::dvec3& v, std::vector<double>& values) {
  for (int axis = 0; axis < 3; ++axis) values.push_back(rounded(v[axis]));
}

/// The skeleton, or none, with one more joint at the origin for the vertices that no other one carries. Null: every
/// vertex is carried.
base::Result<std::shared_ptr<const rig::Skeleton>> carry_all(const rig::Skeleton* skeleton, std::size_t vertices) {
  std::vector<rig::Joint> joints;
  if (skeleton != nullptr) joints.assign(skeleton->joints().begin(), skeleton->joints().end());
  const auto added = static_cast<std::uint32_t>(joints.size());
  std::vector<std::uint32_t> first{0};
  std::vector<rig::Influence> influences;
  bool needed = false;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const auto own = skeleton == nullptr ? std::span<const rig::Influence>() : skeleton->influences_of(v);
    influences.insert(influences.end(), own.begin(), own.end());
    if (own.empty()) influences.push_back({added, 1.0});
    needed = needed || own.empty();
    first.push_back(static_cast<std::uint32_t>(influences.size()));
  }
  if (!needed) return std::shared_ptr<const rig::Skeleton>();
  rig::Joint joint;
  joint.name = "head";
  const auto taken = [&](const rig::Joint& other) { return other.name == joint.name; };
  for (int i = 2; std::any_of(joints.begin(), joints.end(), taken); ++i) joint.name = "head." + std::to_string(i);
  joint.posable = false;
  joints.push_back(std::move(joint));
  return rig::Skeleton::make(std::move(joints), std::move(first), std::move(influences));
}

}  // namespace

Animation make_animation(const Model& model, std::string name, std::span<const double> times_s,
                         std::span<const rig::Pose> poses) {
  Animation animation;
  animation.name = std::move(name);
  const Keys keys = make_keys(times_s);
  const std::size_t weights = weight_count(model);
  if (weights > 0 && !keys.frames.empty()) {
    Channel channel;
    channel.times_s = keys.times_s;
    for (const std::size_t f : keys.frames) {
      for (std::size_t i = 0; i < weights; ++i) channel.values.push_back(rounded(poses[f][i]));
    }
    animation.channels.push_back(std::move(channel));
  }
  if (!model.skeleton) return animation;
  std::size_t parameter = weights;
  for (std::uint32_t j = 0; j < model.skeleton->joints().size(); ++j) {
    const rig::Joint& joint = model.skeleton->joints()[j];
    if (!joint.posable) continue;
    const auto angles = [&](std::size_t f) {
      return glm::dvec3(poses[f][parameter], poses[f][parameter + 1], poses[f][parameter + 2]);
    };
    const bool turns = std::any_of(keys.frames.begin(), keys.frames.end(),
                                   [&](std::size_t f) { return angles(f) != angles(keys.frames.front()); });
    if (turns) {
      Channel channel{ChannelTarget::rotation, j, Interpolation::linear, keys.times_s, {}};
      for (const std::size_t f : keys.frames) {
        add_quaternion(joint.rest_rotation * geometry::quaternion_from_xyz(angles(f)), channel.values);
      }
      animation.channels.push_back(std::move(channel));
    }
    parameter += 3;
  }
  return animation;
}

base::Result<Model> with_placements(Model model, std::size_t animation, const geometry::ModelPoint& pivot,
                                    std::span<const double> times_s, std::span<const Placement> placements) {
  auto skeleton = carry_all(model.skeleton.get(), model.mesh->vertex_count());
  if (!skeleton) return skeleton.error();
  if (*skeleton) {
    auto made = make_model(model.mesh, model.shapes, std::move(skeleton).value(), model.deformers, model.corrections);
    if (!made) return made;
    move_rest(model, *made);
    made->pose = std::move(model.pose);
    made->expressions = std::move(model.expressions);
    model = std::move(made).value();
  }
  const Keys keys = make_keys(times_s);
  for (std::uint32_t j = 0; j < model.skeleton->joints().size(); ++j) {
    const rig::Joint& joint = model.skeleton->joints()[j];
    if (joint.parent >= 0) continue;
    auto& channels = model.animations[animation].channels;
    std::erase_if(channels, [&](const Channel& c) { return c.target != ChannelTarget::weights && c.joint == j; });
    using enum ChannelTarget;
    Channel shift{translation, j, Interpolation::linear, keys.times_s, {}};
    Channel turn{rotation, j, Interpolation::linear, keys.times_s, {}};
    Channel size{scale, j, Interpolation::linear, keys.times_s, {}};
    for (const std::size_t f : keys.frames) {
      const Placement& placement = placements[f];
      add_vector(pivot + placement.shift + placement.rotation * (joint.translation - pivot) * placement.scale,
                 shift.values);
      add_quaternion(placement.rotation * joint.rest_rotation, turn.values);
      add_vector(joint.scale * placement.scale, size.values);
    }
    channels.push_back(std::move(shift));
    channels.push_back(std::move(turn));
    channels.push_back(std::move(size));
  }
  return model;
}

}  // namespace penpose::document
