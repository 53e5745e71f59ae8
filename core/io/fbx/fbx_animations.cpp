#include "core/io/fbx/fbx_animations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace penpose::io {
namespace {

/// FBX counts time in these parts of a second.
constexpr double k_ticks = 46186158000.0;
constexpr double k_samples_a_second = 30.0;
constexpr std::size_t k_most_keys = 1'000'000;

/// A curve of keys: straight, stepped, or splines of the slopes that the file gives.
class FbxCurve {
 public:
  explicit FbxCurve(const FbxObject& object) {
    const std::vector<std::int64_t> ticks = object.record->wholes("KeyTime");
    values_ = object.record->numbers("KeyValueFloat");
    const std::vector<std::int64_t> flags = object.record->wholes("KeyAttrFlags");
    const std::vector<double> slopes = object.record->numbers("KeyAttrDataFloat");
    const std::vector<std::int64_t> counts = object.record->wholes("KeyAttrRefCount");
    if (ticks.size() != values_.size() || ticks.size() > k_most_keys) {
      values_.clear();
      return;
    }
    for (const std::int64_t tick : ticks) times_.push_back(static_cast<double>(tick) / k_ticks);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const bool ascends = i == 0 || times_[i] > times_[i - 1];
      if (ascends && std::isfinite(values_[i])) continue;
      values_.clear();
      return;
    }
    std::size_t key = 0;
    for (std::size_t a = 0; a < flags.size(); ++a) {
      const std::int64_t count = a < counts.size() ? counts[a] : 1;
      for (std::int64_t k = 0; k < count && key < values_.size(); ++k, ++key) {
        const auto slope = [&](std::size_t i) { return 4 * a + i < slopes.size() ? slopes[4 * a + i] : 0.0; };
        kinds_.push_back({flags[a], slope(0), slope(1)});
      }
    }
    kinds_.resize(values_.size());
  }

  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  [[nodiscard]] bool usable() const { return !values_.empty(); }
  /// Whether something but straight lines leads from key to key.
  [[nodiscard]] bool bends() const {
    return std::any_of(kinds_.begin(), kinds_.end(), [](const Kind& kind) { return (kind.flags & k_linear) == 0; });
  }
  [[nodiscard]] double at(double time_s) const {
    const auto next = std::upper_bound(times_.begin(), times_.end(), time_s);
    if (next == times_.begin()) return values_.front();
    const auto i = static_cast<std::size_t>(next - times_.begin()) - 1;
    if (next == times_.end()) return values_.back();
    const double length = times_[i + 1] - times_[i];
    const double t = (time_s - times_[i]) / length;
    const Kind& kind = kinds_[i];
    if ((kind.flags & k_constant) != 0) return (kind.flags & k_next) != 0 ? values_[i + 1] : values_[i];
    if ((kind.flags & k_cubic) == 0) return values_[i] + (values_[i + 1] - values_[i]) * t;
    // Hermite's polynomials.
    const double u = t - 1.0;
    return (1.0 + 2.0 * t) * u * u * values_[i] + t * t * (3.0 - 2.0 * t) * values_[i + 1] +
           length * (t * u * u * kind.leaves + t * t * u * kind.arrives);
  }

 private:
  static constexpr std::int64_t k_constant = 0x2, k_linear = 0x4, k_cubic = 0x8, k_next = 0x100;
  struct Kind {
    std::int64_t flags = k_linear;
    double leaves = 0, arrives = 0;  ///< slopes a second, at this key and at the next one
  };
  std::vector<double> times_, values_;
  std::vector<Kind> kinds_;
};

/// The times of all curves, and those between them where one bends.
std::vector<double> times_of(std::span<const FbxCurve> curves, bool dense) {
  std::vector<double> times;
  for (const FbxCurve& curve : curves) times.insert(times.end(), curve.times().begin(), curve.times().end());
  std::stable_sort(times.begin(), times.end());
  const bool bends =
      dense || std::any_of(curves.begin(), curves.end(), [](const FbxCurve& curve) { return curve.bends(); });
  if (bends && times.size() > 1) {
    const double first = times.front();
    const double steps = std::min(std::floor((times.back() - first) * k_samples_a_second), double{k_most_keys});
    for (double i = 1; i <= steps; ++i) times.push_back(first + i / k_samples_a_second);
    std::stable_sort(times.begin(), times.end());
  }
  times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < 1e-6; }), times.end());
  return times;
}

class Takes {
 public:
  Takes(const FbxScene& scene, const FbxJoints& joints, const std::vector<rig::BlendShape>& shapes)
      : scene_(scene), joints_(joints), shapes_(shapes) {}

  std::vector<document::Animation> read() {
    std::vector<document::Animation> out;
    for (const FbxObject& stack : scene_.objects()) {
      if (stack.kind != "AnimationStack") continue;
      document::Animation animation;
      animation.name = stack.name;
      weights_.clear();
      // Layers above the first one are blends of takes, which are left out.
      const auto layers = scene_.parts_of(stack.id, "AnimationLayer");
      if (layers.empty()) continue;
      const auto nodes = scene_.parts_of(layers.front()->id, "AnimationCurveNode");
      for (const FbxObject* node : nodes) add(*node, animation);
      add_weights(animation);
      if (!animation.channels.empty()) out.push_back(std::move(animation));
    }
    return out;
  }

 private:
  [[nodiscard]] std::optional<FbxCurve> curve_at(const FbxObject& node, const char* property) const {
    const FbxObject* curve = scene_.part_at(node.id, property);
    if (curve == nullptr || curve->kind != "AnimationCurve") return std::nullopt;
    FbxCurve read(*curve);
    return read.usable() ? std::optional(std::move(read)) : std::nullopt;
  }

  void add(const FbxObject& node, document::Animation& animation) {
    for (const FbxConnection& to : scene_.wholes_of(node.id)) {
      const FbxObject* whole = scene_.object(to.object);
      if (whole == nullptr) continue;
      if (to.property == "DeformPercent") {
        const auto curve = curve_at(node, "d|DeformPercent");
        if (curve) weights_.emplace_back(whole->name, *curve);
      }
      const auto joint = joints_.number.find(whole->id);
      if (joint == joints_.number.end()) continue;
      if (to.property == "Lcl Translation") add_joint(node, *whole, joint->second, 0, animation);
      if (to.property == "Lcl Rotation") add_joint(node, *whole, joint->second, 1, animation);
      if (to.property == "Lcl Scaling") add_joint(node, *whole, joint->second, 2, animation);
    }
  }

  void add_joint(const FbxObject& node, const FbxObject& whole, std::uint32_t joint, int what,
                 document::Animation& animation) {
    constexpr std::array<const char*, 3> k_axes{"d|X", "d|Y", "d|Z"};
    std::array<std::optional<FbxCurve>, 3> curves;
    std::vector<FbxCurve> all;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      curves[axis] = curve_at(node, k_axes[axis]);
      if (curves[axis]) all.push_back(*curves[axis]);
    }
    if (all.empty()) return;
    document::Channel channel;
    channel.joint = joint;
    channel.target = what == 0   ? document::ChannelTarget::translation
                     : what == 1 ? document::ChannelTarget::rotation
                                 : document::ChannelTarget::scale;
    const FbxTransform still = transform_of(whole);
    const bool root = scene_.parent_of(whole) == nullptr;
    for (const double time_s : times_of(all, what == 1)) {
      FbxTransform now = still;
      glm::dvec3& vector = what == 0 ? now.translation : what == 1 ? now.rotation : now.scaling;
      for (int axis = 0; axis < 3; ++axis) {
        const auto& curve = curves[static_cast<std::size_t>(axis)];
        if (curve) vector[axis] = curve->at(time_s);
      }
      const glm::dmat4 local = (root ? scene_.to_world() : glm::dmat4(1)) * local_matrix(whole, now);
      channel.times_s.push_back(time_s);
      add_value(local, channel);
    }
    shift_to_zero(channel);
    animation.channels.push_back(std::move(channel));
  }

  static void add_value(const glm::dmat4& local, document::Channel& channel) {
    const FbxLocal parts = parts_of(local);
    if (channel.target != document::ChannelTarget::rotation) {
      const glm::dvec3& vector = channel.target == document::ChannelTarget::scale ? parts.scale : parts.translation;
      for (int i = 0; i < 3; ++i) channel.values.push_back(vector[i]);
      return;
    }
    glm::dquat q = parts.rotation;
    const std::size_t n = channel.values.size();
    if (n >= 4) {
      // The shorter way from the key before.
      const double along = q.x * channel.values[n - 4] + q.y * channel.values[n - 3] + q.z * channel.values[n - 2] +
                           q.w * channel.values[n - 1];
      if (along < 0.0) q = -q;
    }
    for (const double one : {q.x, q.y, q.z, q.w}) channel.values.push_back(one);
  }

  /// Keys before the first moment are moved to it: times of a model are never below 0.
  static void shift_to_zero(document::Channel& channel) {
    if (channel.times_s.empty() || channel.times_s.front() >= 0.0) return;
    const double first = channel.times_s.front();
    for (double& time_s : channel.times_s) time_s -= first;
  }

  void add_weights(document::Animation& animation) const {
    if (weights_.empty()) return;
    std::vector<FbxCurve> all;
    for (const auto& [name, curve] : weights_) all.push_back(curve);
    document::Channel channel;
    channel.times_s = times_of(all, false);
    for (const double time_s : channel.times_s) {
      for (const rig::BlendShape& shape : shapes_) {
        const auto at = std::find_if(weights_.begin(), weights_.end(),
                                     [&](const auto& one) { return one.first == shape.parameter.name; });
        channel.values.push_back(at == weights_.end() ? 0.0 : at->second.at(time_s) / 100.0);
      }
    }
    shift_to_zero(channel);
    animation.channels.push_back(std::move(channel));
  }

  const FbxScene& scene_;
  const FbxJoints& joints_;
  const std::vector<rig::BlendShape>& shapes_;
  std::vector<std::pair<std::string, FbxCurve>> weights_;
};

}  // namespace

std::vector<document::Animation> read_fbx_animations(const FbxScene& scene, const FbxJoints& joints,
                                                     const std::vector<rig::BlendShape>& shapes) {
  return Takes(scene, joints, shapes).read();
}

}  // namespace penpose::io
