#include "core/document/time/clips/animation_keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/document/time/animation_poses.h"
#include "core/document/time/animation_sampling.h"
#include "core/document/time/timeline_editing.h"
#include "core/geometry/rotation.h"

namespace penpose::document {
namespace {

/// One control at a key of a channel: its value, and the slopes of what leads there and of what leaves.
struct ValueKey {
  double time_s = 0;
  double value = 0;
  ControlKey key;
};

KeyKind kind_of(Interpolation interpolation) {
  return interpolation == Interpolation::step     ? KeyKind::stepped
         : interpolation == Interpolation::linear ? KeyKind::linear
                                                  : KeyKind::free;
}

/// Without the keys between two of the same value, where the curve is flat; a control that does not move has one.
std::vector<ValueKey> without_repeats(const std::vector<ValueKey>& keys) {
  const auto flat = [&](std::size_t from) {
    return keys[from].value == keys[from + 1].value && keys[from].key.out == 0.0 && keys[from + 1].key.in == 0.0;
  };
  std::vector<ValueKey> left;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const bool inner = k > 0 && k + 1 < keys.size();
    if (!inner || !flat(k - 1) || !flat(k)) left.push_back(keys[k]);
  }
  if (left.size() == 2 && left[0].value == left[1].value && left[0].key.out == 0.0 && left[1].key.in == 0.0)
    left.pop_back();
  return left;
}

class Opening {
 public:
  explicit Opening(const Model& model)
      : model_(model), parameters_(model.rig->parameters()), keys_(none_, parameters_, model.pose) {}

  void take_weights(const Channel& channel) {
    const std::size_t width = weight_count(model_);
    const std::size_t runs = channel.interpolation == Interpolation::cubic_spline ? 3 : 1;
    if (width == 0 || channel.values.size() != channel.times_s.size() * width * runs) return;
    for (std::size_t w = 0; w < width; ++w) {
      std::vector<ValueKey> keys;
      for (std::size_t k = 0; k < channel.times_s.size(); ++k) {
        const double* at = channel.values.data() + k * width * runs + w;
        ValueKey one{channel.times_s[k], runs == 3 ? at[width] : *at, {kind_of(channel.interpolation), 0, 0}};
        if (runs == 3) one.key = {KeyKind::free, at[0], at[2 * width]};
        keys.push_back(one);
      }
      set(w, without_repeats(keys));
    }
  }

  void take_rotation(const Channel& channel) {
    if (!model_.skeleton || channel.times_s.empty()) return;
    for (std::size_t p = 0; p < model_.skeleton->parameters().size(); p += 3) {
      if (model_.skeleton->joint_of(p) == channel.joint) take_turns(channel, weight_count(model_) + p);
    }
  }

  [[nodiscard]] Timeline finish() && { return std::move(keys_).finish(); }

 private:
  struct Turned {
    double time_s = 0;
    glm::dvec3 angles{0};
    KeyKind kind = KeyKind::linear;
  };

  [[nodiscard]] glm::dvec3 angles_at(const Channel& channel, double time_s) const {
    const std::vector<double> q = sample_channel(channel, 4, time_s);
    if (q.size() != 4) return glm::dvec3(0);
    const rig::Joint& joint = model_.skeleton->joints()[channel.joint];
    return geometry::xyz_from_quaternion(glm::conjugate(joint.rest_rotation) * glm::dquat(q[3], q[0], q[1], q[2]));
  }

  /// Adds a key at the later end, and before it those without which the angles would be off in between.
  void add_until(const Channel& channel, const Turned& from, const Turned& to, int depth, std::vector<Turned>& out) {
    constexpr double k_off = 0.2 * std::numbers::pi / 180.0;
    constexpr int k_deepest = 6;
    const double middle_s = 0.5 * (from.time_s + to.time_s);
    if (depth < k_deepest && middle_s > from.time_s && middle_s < to.time_s) {
      double off = 0;
      for (const double share : {0.25, 0.5, 0.75}) {
        const glm::dvec3 is = angles_at(channel, from.time_s + share * (to.time_s - from.time_s));
        const glm::dvec3 off_by = is - (from.angles + share * (to.angles - from.angles));
        for (int axis = 0; axis < 3; ++axis) off = std::max(off, std::abs(off_by[axis]));
      }
      if (off > k_off) {
        const Turned middle{middle_s, angles_at(channel, middle_s), KeyKind::linear};
        add_until(channel, from, middle, depth + 1, out);
        add_until(channel, middle, to, depth + 1, out);
        return;
      }
    }
    // Angles that begin anew at the other end of the circle do not pass through all that lies between.
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(to.angles[axis] - from.angles[axis]) > std::numbers::pi) out.back().kind = KeyKind::stepped;
    }
    out.push_back(to);
  }

  void take_turns(const Channel& channel, std::size_t first) {
    std::vector<Turned> turned;
    const KeyKind kind = channel.interpolation == Interpolation::step ? KeyKind::stepped : KeyKind::linear;
    for (const double time_s : channel.times_s) {
      const Turned now{time_s, angles_at(channel, time_s), kind};
      if (turned.empty() || kind == KeyKind::stepped) {
        turned.push_back(now);
      } else {
        const Turned before = turned.back();
        add_until(channel, before, now, 0, turned);
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      const rig::Parameter& range = parameters_[first + static_cast<std::size_t>(axis)];
      std::vector<ValueKey> keys;
      for (const Turned& one : turned)
        keys.push_back({one.time_s, std::clamp(one.angles[axis], range.minimum, range.maximum), {one.kind, 0, 0}});
      set(first + static_cast<std::size_t>(axis), without_repeats(keys));
    }
  }

  void set(std::size_t parameter, const std::vector<ValueKey>& keys) {
    const rig::Parameter& range = parameters_[parameter];
    const bool rests = keys.size() == 1 && keys[0].value == range.rest && model_.pose[parameter] == range.rest;
    if (rests) return;
    for (const ValueKey& one : keys) {
      if (one.time_s < 0 || one.time_s > k_latest_key_s) continue;
      keys_.set(one.time_s, parameter, std::clamp(one.value, range.minimum, range.maximum), one.key);
    }
  }

  const Model& model_;
  std::span<const rig::Parameter> parameters_;
  Timeline none_;
  TimelineEditing keys_;
};

}  // namespace

base::Result<Timeline> keys_of(const Model& model, const Animation& animation) {
  if (moments_of(animation).size() > k_most_opened_moments)
    return base::Error{"it has more than 20000 moments", "animation", "cut it into shorter ones"};
  Opening opening(model);
  for (const Channel& channel : animation.channels) {
    if (channel.target == ChannelTarget::weights) opening.take_weights(channel);
    if (channel.target == ChannelTarget::rotation) opening.take_rotation(channel);
  }
  Timeline timeline = std::move(opening).finish();
  if (timeline.keys.empty())
    return base::Error{"it moves nothing that the model has a control for", "animation", "choose another one"};
  return timeline;
}

}  // namespace penpose::document
