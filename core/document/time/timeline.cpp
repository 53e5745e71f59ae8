#include "core/document/time/timeline.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rotation.h"

namespace penpose::document {
namespace {

/// Value at u in 0..1 of the cubic Hermite curve of a segment `length_s` long.
double hermite(double a, double slope_a, double b, double slope_b, double length_s, double u) {
  const double u2 = u * u;
  const double u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * a + (u3 - 2 * u2 + u) * length_s * slope_a + (3 * u2 - 2 * u3) * b +
         (u3 - u2) * length_s * slope_b;
}

std::vector<double> times_of(std::span<const PoseKey> keys) {
  std::vector<double> times;
  for (const PoseKey& key : keys) times.push_back(key.time_s);
  return times;
}

std::vector<double> values_of(std::span<const PoseKey> keys, std::size_t parameter) {
  std::vector<double> values;
  for (const PoseKey& key : keys) values.push_back(key.pose[parameter]);
  return values;
}

/// The segment that holds the moment: the key before it, with a key after it. Precondition: two keys or more.
std::size_t segment_of(const Timeline& timeline, double time_s) {
  std::size_t k = 0;
  while (k + 2 < timeline.keys.size() && timeline.keys[k + 1].time_s <= time_s) ++k;
  return k;
}

Channel weight_channel(const Timeline& timeline, std::size_t count) {
  Channel channel;
  channel.times_s = times_of(timeline.keys);
  const bool smooth = timeline.interpolation == KeyInterpolation::smooth && timeline.keys.size() > 1;
  channel.interpolation = smooth ? Interpolation::cubic_spline : Interpolation::linear;
  if (!smooth) {
    for (const PoseKey& key : timeline.keys) {
      channel.values.insert(channel.values.end(), key.pose.begin(),
                            key.pose.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return channel;
  }
  // In-tangent, value and out-tangent of every key.
  channel.values.resize(timeline.keys.size() * 3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> values = values_of(timeline.keys, i);
    const std::vector<double> tangents = monotone_tangents(channel.times_s, values);
    for (std::size_t k = 0; k < values.size(); ++k) {
      double* row = channel.values.data() + k * 3 * count;
      row[i] = tangents[k];
      row[count + i] = values[k];
      row[2 * count + i] = tangents[k];
    }
  }
  return channel;
}

std::vector<double> sampling_times(const Timeline& timeline, double samples_per_s) {
  std::vector<double> times{timeline.keys.front().time_s};
  for (std::size_t k = 0; k + 1 < timeline.keys.size(); ++k) {
    const double from = timeline.keys[k].time_s;
    const double length = timeline.keys[k + 1].time_s - from;
    const auto steps = static_cast<std::size_t>(std::clamp(std::ceil(length * samples_per_s), 1.0, 1e5));
    for (std::size_t i = 1; i < steps; ++i) {
      times.push_back(from + length * (static_cast<double>(i) / static_cast<double>(steps)));
    }
    times.push_back(timeline.keys[k + 1].time_s);
  }
  return times;
}

bool turns(const Timeline& timeline, std::size_t parameter) {
  const double first = timeline.keys.front().pose[parameter];
  return std::any_of(timeline.keys.begin(), timeline.keys.end(),
                     [&](const PoseKey& key) { return key.pose[parameter] != first || first != 0.0; });
}

/// The joint's rotation below its parent. `first` is its first parameter of `values`.
glm::dquat local_rotation(const rig::Joint& joint, std::span<const double> values, std::size_t first) {
  return joint.rest_rotation * geometry::quaternion_from_xyz({values[first], values[first + 1], values[first + 2]});
}

void add_joint_channels(const Model& model, const Timeline& timeline, double samples_per_s, Animation& animation) {
  const std::size_t first = weight_count(model);
  std::vector<std::size_t> turned;  // the first of the three parameters of every joint that turns
  for (std::size_t p = 0; p < model.skeleton->parameters().size(); p += 3) {
    const bool any = turns(timeline, first + p) || turns(timeline, first + p + 1) || turns(timeline, first + p + 2);
    if (any) turned.push_back(p);
  }
  if (turned.empty()) return;
  const std::vector<double> times = sampling_times(timeline, samples_per_s);
  for (const std::size_t p : turned) {
    Channel channel;
    channel.target = ChannelTarget::rotation;
    channel.joint = model.skeleton->joint_of(p);
    channel.times_s = times;
    animation.channels.push_back(std::move(channel));
  }
  for (const double time : times) {
    const rig::Pose pose = sample(timeline, time);
    for (std::size_t c = 0; c < turned.size(); ++c) {
      Channel& channel = animation.channels[animation.channels.size() - turned.size() + c];
      const rig::Joint& joint = model.skeleton->joints()[channel.joint];
      const glm::dquat q = local_rotation(joint, pose, first + turned[c]);
      auto& values = channel.values;
      values.insert(values.end(), {q.x, q.y, q.z, q.w});
    }
  }
}

}  // namespace

std::vector<double> monotone_tangents(std::span<const double> times_s, std::span<const double> values) {
  const std::size_t n = values.size();
  std::vector<double> tangents(n, 0.0);
  if (n < 3) {
    // A straight line between two keys would start and stop with a jerk; flat ends ease in and out.
    return tangents;
  }
  std::vector<double> secants(n - 1);
  for (std::size_t k = 0; k + 1 < n; ++k) secants[k] = (values[k + 1] - values[k]) / (times_s[k + 1] - times_s[k]);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double a = secants[k - 1];
    const double b = secants[k];
    if (a * b <= 0.0) continue;
    // The mean slope, cut so that neither neighbouring segment overshoots (the square of side 3).
    const double mean = 0.5 * (a + b);
    const double limit = 3.0 * std::min(std::abs(a), std::abs(b));
    tangents[k] = std::clamp(mean, -limit, limit);
  }
  return tangents;
}

rig::Pose sample(const Timeline& timeline, double time_s) {
  const auto& keys = timeline.keys;
  if (time_s <= keys.front().time_s || keys.size() == 1) return keys.front().pose;
  if (time_s >= keys.back().time_s) return keys.back().pose;
  const std::size_t k = segment_of(timeline, time_s);
  const double length = keys[k + 1].time_s - keys[k].time_s;
  const double u = (time_s - keys[k].time_s) / length;
  rig::Pose pose = keys[k].pose;
  // A tangent asks for the neighbours of its key alone.
  const std::size_t first = k > 0 ? k - 1 : 0;
  const std::span<const PoseKey> near(keys.data() + first, std::min(keys.size(), k + 3) - first);
  const std::vector<double> times = times_of(near);
  for (std::size_t i = 0; i < pose.size(); ++i) {
    const double a = keys[k].pose[i];
    const double b = keys[k + 1].pose[i];
    if (timeline.interpolation == KeyInterpolation::linear) {
      pose[i] = a + (b - a) * u;
      continue;
    }
    const std::vector<double> tangents = monotone_tangents(times, values_of(near, i));
    const double value = hermite(a, tangents[k - first], b, tangents[k - first + 1], length, u);
    // Rounding alone could leave the keys' span, and with it the parameter's range.
    pose[i] = std::clamp(value, std::min(a, b), std::max(a, b));
  }
  return pose;
}

Animation to_animation(const Model& model, const Timeline& timeline, double joint_samples_per_s) {
  Animation animation{"timeline", {}};
  if (timeline.keys.empty()) return animation;
  const std::size_t count = weight_count(model);
  if (count > 0) animation.channels.push_back(weight_channel(timeline, count));
  if (model.skeleton) add_joint_channels(model, timeline, joint_samples_per_s, animation);
  return animation;
}

}  // namespace penpose::document
