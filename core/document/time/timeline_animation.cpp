#include "core/document/time/timeline_animation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/geometry/rotation.h"

namespace penpose::document {
namespace {

/// One control at a moment of the channel: its value, and the slopes of what leads there and of what leaves.
struct ChannelKey {
  double in = 0, value = 0, out = 0;
};

/// All keys of one control in turn.
class ControlCurve {
 public:
  ControlCurve(const Timeline& timeline, std::size_t parameter, double unkeyed) : unkeyed_(unkeyed) {
    std::optional<std::size_t> before;
    for (std::size_t k = 0; k < timeline.keys.size(); ++k) {
      if (!timeline.keys[k].controls.has(parameter)) continue;
      if (before) {
        segments_.push_back(document::segment_of(timeline, parameter, *before, k));
      } else {
        first_ = {timeline.keys[k].time_s, timeline.keys[k].pose[parameter]};
      }
      before = k;
    }
  }

  [[nodiscard]] const std::vector<KeySegment>& segments() const { return segments_; }
  [[nodiscard]] bool all_are(KeyKind kind) const {
    return std::all_of(segments_.begin(), segments_.end(), [&](const KeySegment& one) { return one.kind == kind; });
  }
  [[nodiscard]] ChannelKey at(double time_s) const {
    if (!first_) return {0, unkeyed_, 0};
    const auto after = std::partition_point(segments_.begin(), segments_.end(),
                                            [&](const KeySegment& one) { return one.to_s <= time_s; });
    ChannelKey key{0, first_->second, 0};
    if (after != segments_.begin()) {
      const KeySegment& before = *std::prev(after);
      key.value = before.to;
      if (before.to_s == time_s) key.in = slope_at(before, time_s);
    }
    if (after != segments_.end() && after->from_s <= time_s) {
      key.value = value_at(*after, time_s);
      key.out = slope_at(*after, time_s);
      if (after->from_s < time_s) key.in = key.out;
    }
    return key;
  }

 private:
  double unkeyed_;
  std::optional<std::pair<double, double>> first_;  ///< the first key's moment and value
  std::vector<KeySegment> segments_;
};

std::vector<ControlCurve> curves_of(const Model& model, const Timeline& timeline, std::size_t first,
                                    std::size_t count) {
  std::vector<ControlCurve> curves;
  for (std::size_t i = first; i < first + count; ++i) curves.emplace_back(timeline, i, model.pose[i]);
  return curves;
}

/// The last moment before another one that files, which have floats, can tell from it.
double just_before(double time_s) {
  const auto time = static_cast<float>(time_s);
  return static_cast<double>(std::nextafter(time, -std::numeric_limits<float>::infinity()));
}

/// The moments of all keys, and those just before a held value ends.
std::vector<double> moments_of(const Timeline& timeline, std::span<const ControlCurve> curves, bool with_holds) {
  std::vector<double> ends;
  for (const ControlCurve& curve : curves) {
    for (const KeySegment& one : curve.segments()) {
      if (with_holds && one.kind == KeyKind::stepped) ends.push_back(just_before(one.to_s));
    }
  }
  std::stable_sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<double> keys;
  for (const PoseKey& key : timeline.keys) keys.push_back(key.time_s);
  std::vector<double> moments;
  std::merge(keys.begin(), keys.end(), ends.begin(), ends.end(), std::back_inserter(moments));
  moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
  return moments;
}

Channel weight_channel(const Model& model, const Timeline& timeline, std::size_t count) {
  const std::vector<ControlCurve> curves = curves_of(model, timeline, 0, count);
  const auto all_are = [&](KeyKind kind) {
    return std::all_of(curves.begin(), curves.end(), [&](const ControlCurve& curve) { return curve.all_are(kind); });
  };
  Channel channel;
  const bool stepped = timeline.keys.size() > 1 && all_are(KeyKind::stepped);
  const bool straight = !stepped && all_are(KeyKind::linear);
  channel.interpolation = stepped    ? Interpolation::step
                          : straight ? Interpolation::linear
                                     : Interpolation::cubic_spline;
  channel.times_s = moments_of(timeline, curves, !stepped && !straight);
  for (const double time_s : channel.times_s) {
    std::vector<double> in;
    std::vector<double> values;
    std::vector<double> out;
    for (const ControlCurve& curve : curves) {
      const ChannelKey key = curve.at(time_s);
      in.push_back(key.in);
      values.push_back(key.value);
      out.push_back(key.out);
    }
    if (channel.interpolation == Interpolation::cubic_spline)
      channel.values.insert(channel.values.end(), in.begin(), in.end());
    channel.values.insert(channel.values.end(), values.begin(), values.end());
    if (channel.interpolation == Interpolation::cubic_spline)
      channel.values.insert(channel.values.end(), out.begin(), out.end());
  }
  return channel;
}

std::vector<double> sampling_times(std::span<const double> moments, double samples_per_s) {
  std::vector<double> times{moments.front()};
  for (std::size_t k = 0; k + 1 < moments.size(); ++k) {
    const double length = moments[k + 1] - moments[k];
    const auto steps = static_cast<std::size_t>(std::clamp(std::ceil(length * samples_per_s), 1.0, 1e5));
    for (std::size_t i = 1; i < steps; ++i) {
      times.push_back(moments[k] + length * (static_cast<double>(i) / static_cast<double>(steps)));
    }
    times.push_back(moments[k + 1]);
  }
  return times;
}

void add_joint_channels(const Model& model, const Timeline& timeline, double samples_per_s, Animation& animation) {
  const std::size_t first = weight_count(model);
  const std::size_t count = model.skeleton->parameters().size();
  const std::vector<ControlCurve> curves = curves_of(model, timeline, first, count);
  const auto turns = [&](std::size_t parameter) {
    const double at_first = timeline.keys.front().pose[first + parameter];
    return at_first != 0.0 || std::any_of(timeline.keys.begin(), timeline.keys.end(),
                                          [&](const PoseKey& key) { return key.pose[first + parameter] != at_first; });
  };
  const std::vector<double> times = sampling_times(moments_of(timeline, curves, true), samples_per_s);
  for (std::size_t p = 0; p < count; p += 3) {
    if (!turns(p) && !turns(p + 1) && !turns(p + 2)) continue;
    Channel channel;
    channel.target = ChannelTarget::rotation;
    channel.joint = model.skeleton->joint_of(p);
    channel.times_s = times;
    const rig::Joint& joint = model.skeleton->joints()[channel.joint];
    for (const double time_s : times) {
      const glm::dvec3 angles{curves[p].at(time_s).value, curves[p + 1].at(time_s).value,
                              curves[p + 2].at(time_s).value};
      // Below its parent.
      const glm::dquat q = joint.rest_rotation * geometry::quaternion_from_xyz(angles);
      channel.values.insert(channel.values.end(), {q.x, q.y, q.z, q.w});
    }
    animation.channels.push_back(std::move(channel));
  }
}

}  // namespace

Animation to_animation(const Model& model, const Timeline& timeline, double joint_samples_per_s) {
  Animation animation{"timeline", {}};
  if (timeline.keys.empty()) return animation;
  const std::size_t count = weight_count(model);
  if (count > 0) animation.channels.push_back(weight_channel(model, timeline, count));
  if (model.skeleton) add_joint_channels(model, timeline, joint_samples_per_s, animation);
  return animation;
}

}  // namespace penpose::document
