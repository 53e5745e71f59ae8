#include "core/tracking/motion_animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/base/math.h"
#include "core/document/expressions.h"
#include "core/document/humanoid_rest.h"
#include "core/document/time/animation_sampling.h"
#include "core/geometry/rotation.h"
#include "core/rig/control_names.h"

namespace penpose::tracking {
namespace {

using document::Channel;
using document::ChannelTarget;
using document::HumanBone;
using document::Interpolation;

glm::dquat quaternion_at(const Channel& channel, double time_s) {
  const auto v = document::sample_channel(channel, 4, time_s);
  return v.size() == 4 ? glm::dquat(v[3], v[0], v[1], v[2]) : glm::dquat(1, 0, 0, 0);
}

double rounded(double value) { return static_cast<double>(static_cast<float>(value)); }

/// All times of some channels, and within splines seven more between two keys.
std::vector<double> times_of(const std::vector<const Channel*>& channels) {
  std::vector<double> times;
  for (const Channel* channel : channels) {
    const auto& keys = channel->times_s;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      times.push_back(rounded(keys[k]));
      for (int i = 1; channel->interpolation == Interpolation::cubic_spline && k + 1 < keys.size() && i < 8; ++i)
        times.push_back(rounded(keys[k] + (keys[k + 1] - keys[k]) * i / 8.0));
    }
  }
  std::stable_sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Numbers that an animation may unfold to: an hour at 60 frames a second of 150 controls.
constexpr std::size_t k_most_numbers = 36'000'000;

base::Error too_many() {
  return {"its keys are at more times than can be played", "/animations/0", "export it at 30 frames a second"};
}

bool same_keys(const std::vector<const Channel*>& channels) {
  return std::all_of(channels.begin(), channels.end(), [&](const Channel* one) {
    return one->interpolation == channels.front()->interpolation && one->times_s == channels.front()->times_s;
  });
}

class Player {
 public:
  Player(const document::Model& model, const io::MotionTrack& motion)
      : model_(model),
        motion_(motion),
        humanoid_(document::humanoid_of(model)),
        front_(geometry::quaternion_from_xyz({0, base::radians(model.front_yaw_degrees), 0})) {
    if (model.skeleton) rest_ = document::rest_joints(model.skeleton->joints());
    for (const io::BoneMotion& one : motion.bones) motion_of_[static_cast<std::size_t>(one.bone)] = &one.rotations;
  }

  base::Result<MotionAnimation> play() {
    result_.animation.name = "tracked";
    result_.notes = motion_.notes;
    if (auto status = play_expressions(); !status) return status.error();
    for (std::size_t b = 0; b < document::k_human_bones; ++b) turn(static_cast<HumanBone>(b));
    move_hips();
    note_missing();
    if (result_.animation.channels.empty()) {
      return base::Error{"the model has none of the " + std::to_string(motion_.bones.size()) + " bones and " +
                             std::to_string(motion_.expressions.size()) + " expressions that the motion has",
                         "", "give a model with a skeleton, or with the expressions as controls"};
    }
    std::vector<double> times;
    for (const Channel& channel : result_.animation.channels)
      times.insert(times.end(), channel.times_s.begin(), channel.times_s.end());
    std::stable_sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.size() > k_most_numbers / std::max<std::size_t>(1, model_.rig->parameters().size())) return too_many();
    result_.times_s = std::move(times);
    return std::move(result_);
  }

 private:
  /// The rotations of bones above that the model lacks, from the top, and then its own.
  [[nodiscard]] std::vector<const Channel*> motions_for(HumanBone bone) const {
    std::vector<const Channel*> all;
    if (const Channel* own = motion_of_[static_cast<std::size_t>(bone)]) all.push_back(own);
    for (auto up = document::parent_of(bone); up && !humanoid_.joint(*up); up = document::parent_of(*up)) {
      if (const Channel* above = motion_of_[static_cast<std::size_t>(*up)]) all.push_back(above);
    }
    std::reverse(all.begin(), all.end());
    return all;
  }

  void turn(HumanBone bone) {
    const auto joint = humanoid_.joint(bone);
    if (!joint) return;
    const bool eye = bone == HumanBone::left_eye || bone == HumanBone::right_eye;
    // What turns the eyes in VRM is the gaze; older files animate them as bones.
    const bool gaze = eye && motion_.gaze.has_value();
    std::vector<const Channel*> motions = gaze ? std::vector<const Channel*>{&*motion_.gaze} : motions_for(bone);
    if (motions.empty()) return;
    const document::RestJoint& rest = rest_[*joint];
    const glm::dquat before = glm::conjugate(rest.parent_rotation) * front_;
    const glm::dquat after = glm::conjugate(front_) * rest.rotation;
    Channel channel{ChannelTarget::rotation, *joint, Interpolation::linear, {}, {}};
    const auto add = [&](const glm::dquat& normalised) {
      const glm::dquat q = before * normalised * after;
      for (const double part : {q.x, q.y, q.z, q.w}) channel.values.push_back(rounded(part));
    };
    if (motions.size() == 1) {
      // Linear in the quaternion, so that keys and tangents stay keys and tangents.
      const Channel& from = *motions.front();
      channel.interpolation = from.interpolation;
      channel.times_s = from.times_s;
      for (std::size_t i = 0; i + 4 <= from.values.size(); i += 4)
        add({from.values[i + 3], from.values[i], from.values[i + 1], from.values[i + 2]});
    } else {
      if (same_keys(motions) && motions.front()->interpolation == Interpolation::step)
        channel.interpolation = Interpolation::step;
      channel.times_s = times_of(motions);
      for (const double time : channel.times_s) {
        glm::dquat whole(1, 0, 0, 0);
        for (const Channel* one : motions) whole = whole * quaternion_at(*one, time);
        add(whole);
      }
    }
    result_.animation.channels.push_back(std::move(channel));
  }

  void move_hips() {
    const auto joint = humanoid_.joint(HumanBone::hips);
    if (!joint || !motion_.hips) return;
    const document::RestJoint& rest = rest_[*joint];
    const double ratio = std::abs(motion_.hips_height) > 1e-6 ? rest.position.y / motion_.hips_height : 1.0;
    const glm::dmat4 from_world = glm::inverse(rest.parent_matrix);
    Channel channel{ChannelTarget::translation, *joint, motion_.hips->interpolation, motion_.hips->times_s, {}};
    const bool cubic = channel.interpolation == Interpolation::cubic_spline;
    for (std::size_t i = 0; i + 3 <= motion_.hips->values.size(); i += 3) {
      const double* v = &motion_.hips->values[i];
      const bool tangent = cubic && i / 3 % 3 != 1;
      const glm::dvec3 world = front_ * (glm::dvec3(v[0], v[1], v[2]) * ratio);
      const glm::dvec4 local = from_world * glm::dvec4(world, tangent ? 0 : 1);
      for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(local[axis]) < 1e15)) return;  // a parent of no size
        channel.values.push_back(rounded(local[axis]));
      }
    }
    result_.animation.channels.push_back(std::move(channel));
  }

  base::Status play_expressions() {
    struct Played {
      const Channel* weights;
      std::vector<std::pair<std::size_t, double>> values;
      std::optional<std::size_t> expression = std::nullopt;
    };
    std::vector<Played> played;
    std::vector<const Channel*> channels;
    for (const io::ExpressionMotion& one : motion_.expressions) {
      Played now{&one.weights, {}, {}};
      if (const auto expression = document::expression_named(model_, one.name)) {
        now.values = model_.expressions[*expression].values;
        now.expression = expression;
      } else {
        for (const std::size_t c : rig::controls_named(model_.rig->parameters(), one.name))
          now.values.emplace_back(c, 1.0);
      }
      std::erase_if(now.values, [&](const auto& value) { return value.first >= document::weight_count(model_); });
      if (now.values.empty()) {
        result_.unmatched.push_back(one.name);
        continue;
      }
      channels.push_back(&one.weights);
      played.push_back(std::move(now));
    }
    if (played.empty()) return base::Done{};
    const std::size_t width = document::weight_count(model_);
    Channel channel;
    if (same_keys(channels) && channels.front()->interpolation == Interpolation::step)
      channel.interpolation = Interpolation::step;
    channel.times_s = times_of(channels);
    if (channel.times_s.size() > k_most_numbers / std::max(width, played.size())) return too_many();
    for (const double time : channel.times_s) {
      std::map<std::size_t, double> sums;
      std::vector<double> weights;
      std::vector<double> of_expressions(model_.expressions.size(), 0.0);
      for (const Played& one : played) {
        const auto sampled = document::sample_channel(*one.weights, 1, time);
        weights.push_back(sampled.empty() ? 0.0 : std::clamp(sampled[0], 0.0, 1.0));
        if (one.expression) of_expressions[*one.expression] = weights.back();
      }
      const std::vector<double> shown = document::shown_weights(model_, of_expressions);
      for (std::size_t p = 0; p < played.size(); ++p) {
        const Played& one = played[p];
        const double weight = one.expression ? shown[*one.expression] : weights[p];
        for (const auto& [parameter, value] : one.values) sums[parameter] += weight * value;
      }
      for (std::size_t i = 0; i < width; ++i) {
        const rig::Parameter& range = model_.rig->parameters()[i];
        const auto sum = sums.find(i);
        channel.values.push_back(
            rounded(sum == sums.end() ? model_.pose[i] : std::clamp(sum->second, range.minimum, range.maximum)));
      }
    }
    result_.animation.channels.push_back(std::move(channel));
    return base::Done{};
  }

  void note_missing() {
    std::string names;
    std::size_t count = 0;
    for (const io::BoneMotion& one : motion_.bones) {
      if (humanoid_.joint(one.bone)) continue;
      if (++count <= 5) names.append(count > 1 ? ", " : "").append(document::name_of(one.bone));
    }
    if (count == 0) return;
    result_.notes.push_back("the model has no joint for " + std::to_string(count) + " bones (" + names +
                            (count > 5 ? ", ..." : "") + "); what they turn goes to the bones below them");
  }

  const document::Model& model_;
  const io::MotionTrack& motion_;
  document::Humanoid humanoid_;
  glm::dquat front_;
  std::vector<document::RestJoint> rest_;
  std::array<const Channel*, document::k_human_bones> motion_of_{};
  MotionAnimation result_;
};

}  // namespace

base::Result<MotionAnimation> animate_motion(const document::Model& model, const io::MotionTrack& motion) {
  return Player(model, motion).play();
}

}  // namespace penpose::tracking
