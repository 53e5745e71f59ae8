#include "core/document/time/animation_sampling.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::document {
namespace {

glm::dquat quaternion_of(std::span<const double> v) { return {v[3], v[0], v[1], v[2]}; }

glm::dquat normalized(const glm::dquat& q) {
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return size > 1e-300 ? q / size : glm::dquat{1, 0, 0, 0};
}

/// Spherical linear, by the shorter way; straight where the angle is too small to divide by its sine.
glm::dquat slerp(const glm::dquat& a, glm::dquat b, double t) {
  double cosine = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  if (cosine < 0) {
    b = -b;
    cosine = -cosine;
  }
  if (cosine > 0.9999) return normalized(a * (1 - t) + b * t);
  const double angle = base::acos(cosine);
  const double inverse = 1.0 / base::sin(angle);
  return normalized(a * (base::sin((1 - t) * angle) * inverse) + b * (base::sin(t * angle) * inverse));
}

void store(const glm::dquat& q, std::span<double> out) {
  out[0] = q.x;
  out[1] = q.y;
  out[2] = q.z;
  out[3] = q.w;
}

/// Where a time falls: between keys `before` and `before` + 1 at share t, or on key `before` with t = 0.
struct Place {
  std::size_t before = 0;
  double t = 0;
  double span_s = 0;
};

Place find_place(std::span<const double> times, double time_s) {
  if (!(time_s > times.front())) return {0, 0, 0};
  if (time_s >= times.back()) return {times.size() - 1, 0, 0};
  const auto next = std::upper_bound(times.begin(), times.end(), time_s);
  const auto before = static_cast<std::size_t>(next - times.begin()) - 1;
  const double span_s = times[before + 1] - times[before];
  return {before, span_s > 0 ? (time_s - times[before]) / span_s : 0.0, span_s};
}

/// Cubic Hermite spline of glTF: a key is in-tangent, value, out-tangent; tangents are per second.
void sample_cubic(std::span<const double> a, std::span<const double> b, const Place& place, std::span<double> out) {
  const std::size_t width = out.size();
  const double t = place.t;
  const double t2 = t * t;
  const double t3 = t2 * t;
  for (std::size_t i = 0; i < width; ++i) {
    out[i] = (2 * t3 - 3 * t2 + 1) * a[width + i] + place.span_s * (t3 - 2 * t2 + t) * a[2 * width + i] +
             (3 * t2 - 2 * t3) * b[width + i] + place.span_s * (t3 - t2) * b[i];
  }
}

}  // namespace

double duration_s(const Animation& animation) {
  double last = 0;
  for (const Channel& channel : animation.channels) {
    if (!channel.times_s.empty()) last = std::max(last, channel.times_s.back());
  }
  return last;
}

std::vector<double> sample_channel(const Channel& channel, std::size_t width, double time_s) {
  const bool cubic = channel.interpolation == Interpolation::cubic_spline;
  const std::size_t run = cubic ? 3 * width : width;
  const std::size_t keys = channel.times_s.size();
  if (keys == 0 || width == 0 || channel.values.size() != keys * run) return {};
  const bool rotation = channel.target == ChannelTarget::rotation;
  if (rotation && width != 4) return {};
  const auto key = [&](std::size_t k) { return std::span(channel.values).subspan(k * run, run); };
  const Place place = find_place(channel.times_s, time_s);
  const auto a = key(place.before);
  const auto held = a.subspan(cubic ? width : 0, width);
  std::vector<double> out(held.begin(), held.end());
  if (place.t > 0 && channel.interpolation != Interpolation::step) {
    const auto b = key(place.before + 1);
    if (cubic) {
      sample_cubic(a, b, place, out);
    } else if (rotation) {
      store(slerp(normalized(quaternion_of(a)), normalized(quaternion_of(b)), place.t), out);
    } else {
      for (std::size_t i = 0; i < width; ++i) out[i] = a[i] + (b[i] - a[i]) * place.t;
    }
  }
  if (rotation) store(normalized(quaternion_of(out)), out);
  return out;
}

AnimationSample sample(const Model& model, const Animation& animation, double time_s) {
  AnimationSample moment;
  if (model.skeleton) {
    for (const rig::Joint& joint : model.skeleton->joints()) {
      moment.joints.push_back({joint.translation, joint.rest_rotation, joint.scale});
    }
  }
  const std::size_t count = weight_count(model);
  for (const Channel& channel : animation.channels) {
    const bool weights = channel.target == ChannelTarget::weights;
    const bool rotation = channel.target == ChannelTarget::rotation;
    if (!weights && channel.joint >= moment.joints.size()) continue;
    const auto values = sample_channel(channel, weights ? count : rotation ? 4 : 3, time_s);
    if (values.empty()) continue;
    if (weights) {
      moment.weights = values;
      continue;
    }
    JointTransform& joint = moment.joints[channel.joint];
    if (rotation) joint.rotation = quaternion_of(values);
    if (channel.target == ChannelTarget::translation) joint.translation = {values[0], values[1], values[2]};
    if (channel.target == ChannelTarget::scale) joint.scale = {values[0], values[1], values[2]};
  }
  return moment;
}

base::Result<Model> model_at(const Model& model, const AnimationSample& moment) {
  Model posed = model;
  if (model.skeleton && moment.joints.size() == model.skeleton->joints().size()) {
    const auto rest = model.skeleton->joints();
    std::vector<rig::Joint> joints(rest.begin(), rest.end());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      joints[i].translation = moment.joints[i].translation;
      joints[i].rest_rotation = moment.joints[i].rotation;
      joints[i].scale = moment.joints[i].scale;
    }
    std::vector<std::uint32_t> first{0};
    std::vector<rig::Influence> influences;
    for (std::uint32_t v = 0; v < model.skeleton->vertex_count(); ++v) {
      const auto own = model.skeleton->influences_of(v);
      influences.insert(influences.end(), own.begin(), own.end());
      first.push_back(static_cast<std::uint32_t>(influences.size()));
    }
    auto skeleton = rig::Skeleton::make(std::move(joints), std::move(first), std::move(influences));
    if (!skeleton) return skeleton.error();
    const auto layers = model.rig->layers();
    auto rig = rig::CharacterRig::make(model.mesh, {layers.begin(), layers.end()}, *skeleton);
    if (!rig) return rig.error();
    posed.skeleton = std::move(*skeleton);
    posed.rig = std::move(*rig);
  }
  // Weights are the first parameters: blend shapes, then deformers.
  if (moment.weights.size() != weight_count(model)) return posed;
  std::copy(moment.weights.begin(), moment.weights.end(), posed.pose.begin());
  return posed;
}

}  // namespace penpose::document
