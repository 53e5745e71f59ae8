#include "core/io/fbx/motion/fbx_animations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <utility>

#include "core/io/fbx/motion/fbx_times.h"

namespace penpose::io {
namespace {

constexpr const char* k_move = "Lcl Translation";
constexpr const char* k_turn = "Lcl Rotation";
constexpr const char* k_scale = "Lcl Scaling";
constexpr const char* k_percent = "DeformPercent";

/// Where there are as few moments as this a second, there are keys alone.
constexpr double k_least_rate = 1e-5;

/// A whole number of moments a frame, about thirty to sixty a second.
double rate_of(double frames_per_second) {
  return frames_per_second > 60.0 ? frames_per_second / std::ceil(frames_per_second / 60.0)
                                  : frames_per_second * std::ceil(29.9 / frames_per_second);
}

class TakeReader {
 public:
  TakeReader(const FbxScene& scene, const FbxTake& take, FbxPlaces& places, const FbxJoints& joints,
             const FbxMeshes& meshes, double rate, bool counts, std::size_t& numbers_left)
      : scene_(scene),
        take_(take),
        places_(places),
        joints_(joints),
        meshes_(meshes),
        numbers_left_(numbers_left),
        rate_(rate),
        counts_(counts),
        world_(scene.to_world()) {}

  document::Animation read() {
    for (const FbxObject& node : scene_.objects()) {
      if (node.kind == "Model" && joints_.number.contains(node.id)) add_node(node);
    }
    add_weights();
    if (!counts_) begin_at_zero();
    return std::move(animation_);
  }
  [[nodiscard]] bool lost() const { return lost_; }

 private:
  using Curves = std::vector<const FbxCurve*>;

  const FbxNodeTransform& transform_of(const FbxObject& node) {
    return transforms_.try_emplace(node.id, node).first->second;
  }
  void add_scale_curves(const FbxObject& node, Curves& curves) {
    std::size_t depth = 0;
    for (const FbxObject* one = &node; one != nullptr && ++depth < k_deepest_fbx_node; one = places_.of(*one).source)
      take_.add_curves(one->id, k_scale, curves);
  }
  glm::dvec3 scale_at(const FbxObject& node, double time_s) {
    glm::dvec3 scale(1);
    std::size_t depth = 0;
    for (const FbxObject* one = &node; one != nullptr && ++depth < k_deepest_fbx_node; one = places_.of(*one).source)
      scale *= take_.value(one->id, k_scale, transform_of(*one).still().scaling, time_s);
    return scale;
  }

  void add_node(const FbxObject& node) {
    const FbxPlaces::Place place = places_.of(node);
    Curves moves;
    Curves turns;
    Curves scales;
    take_.add_curves(node.id, k_move, moves);
    take_.add_curves(node.id, k_turn, turns);
    take_.add_curves(node.id, k_scale, scales);
    if (place.source != nullptr) add_scale_curves(*place.source, scales);
    const FbxTransform& still = transform_of(node).still();
    const bool has_pivots = transform_of(node).has_pivots();
    if (has_pivots) {
      if (take_.moves(node.id, k_turn, still.rotation)) take_.add_curves(node.id, k_turn, moves);
      if (take_.moves(node.id, k_scale, still.scaling)) take_.add_curves(node.id, k_scale, moves);
    }
    const bool pivoted = !moves.empty() && has_pivots;
    if (place.inherits != FbxInherits::all) add_scale_curves(*place.parent, moves);
    const FbxJoints::Pair joint = joints_.number.at(node.id);
    if (!moves.empty() || take_.moves(node.id, k_move, still.translation))
      add_channel(node, place, moves, pivoted, joint, document::ChannelTarget::translation);
    if (!turns.empty() || take_.moves(node.id, k_turn, still.rotation))
      add_channel(node, place, turns, true, joint, document::ChannelTarget::rotation);
    if (!scales.empty() || take_.moves(node.id, k_scale, still.scaling))
      add_channel(node, place, scales, false, joint, document::ChannelTarget::scale);
  }

  FbxLocal local_at(const FbxObject& node, const FbxPlaces::Place& place, double time_s) {
    const FbxNodeTransform& transform = transform_of(node);
    FbxTransform now = transform.still();
    now.translation = take_.value(node.id, k_move, now.translation, time_s);
    now.rotation = take_.value(node.id, k_turn, now.rotation, time_s);
    now.scaling = take_.value(node.id, k_scale, now.scaling, time_s);
    glm::dvec3 above(1);
    glm::dvec3 source(1);
    if (place.inherits != FbxInherits::all) {
      above = scale_at(*place.parent, time_s);
      if (place.source != nullptr) source = scale_at(*place.source, time_s);
    }
    return fbx_joint_local(transform.at(now), place, above, source, world_);
  }

  std::optional<FbxTimes> times_of(const Curves& curves, bool turn, std::size_t width) {
    auto times = fbx_times(curves, turn, rate_, take_, numbers_left_ / width);
    lost_ = lost_ || !times;
    if (!times) return times;
    if (times->times_s.empty()) times->times_s.push_back(std::max(0.0, take_.start_s()));
    numbers_left_ -= std::min(numbers_left_, times->times_s.size() * width);
    return times;
  }

  void add_channel(const FbxObject& node, const FbxPlaces::Place& place, const Curves& curves, bool turn,
                   const FbxJoints::Pair& joint, document::ChannelTarget target) {
    const bool rotates = target == document::ChannelTarget::rotation;
    auto times = times_of(curves, turn, rotates ? 5 : 4);
    if (!times || counts_) return;
    document::Channel channel;
    channel.joint = target == document::ChannelTarget::scale ? joint.full : joint.turned;
    channel.target = target;
    if (times->steps) channel.interpolation = document::Interpolation::step;
    channel.times_s = std::move(times->times_s);
    for (const double time_s : channel.times_s) {
      const FbxLocal local = local_at(node, place, time_s);
      if (rotates) {
        add_rotation(local.rotation, channel.values);
        continue;
      }
      // The scale of a joint of its own is not in the unit of the world.
      const glm::dvec3 vector = target == document::ChannelTarget::translation ? local.translation
                                : joint.full == joint.turned                   ? local.scale
                                                                               : scale_at(node, time_s);
      for (int i = 0; i < 3; ++i) channel.values.push_back(std::isfinite(vector[i]) ? vector[i] : 0.0);
    }
    animation_.channels.push_back(std::move(channel));
  }

  static void add_rotation(const glm::dmat3& matrix, std::vector<double>& values) {
    glm::dquat q = fbx_turn(matrix);
    if (const std::size_t n = values.size(); n >= 4) {
      // The shorter way from the key before.
      const double along = q.x * values[n - 4] + q.y * values[n - 3] + q.z * values[n - 2] + q.w * values[n - 1];
      if (along < 0.0) q = -q;
    }
    for (const double one : {q.x, q.y, q.z, q.w}) values.push_back(one);
  }

  [[nodiscard]] double channel_at(const FbxChannel& channel, double time_s) const {
    return take_.value(channel.id, k_percent, glm::dvec3(channel.value * 100.0, 0, 0), time_s).x / 100.0;
  }

  /// Where a channel passes a shape between two times.
  void add_knees(std::vector<double>& times) const {
    std::vector<double> more;
    for (const FbxChannel& channel : meshes_.channels) {
      if (channel.knees.size() < 2 || !take_.drives(channel.id, k_percent)) continue;
      double before = times.empty() ? 0.0 : channel_at(channel, times.front());
      for (std::size_t i = 1; i < times.size(); ++i) {
        const double now = channel_at(channel, times[i]);
        const auto pass = [&](double knee) {
          if ((knee - before) * (now - knee) > 0.0)
            more.push_back(times[i - 1] + (times[i] - times[i - 1]) * (knee - before) / (now - before));
        };
        for (const double knee : channel.knees) pass(knee);
        pass(0.0);
        before = now;
      }
    }
    times.insert(times.end(), more.begin(), more.end());
    std::stable_sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < 1e-6; }), times.end());
  }

  void add_weights() {
    Curves curves;
    bool driven = false;
    for (const FbxChannel& channel : meshes_.channels) {
      take_.add_curves(channel.id, k_percent, curves);
      driven = driven || take_.moves(channel.id, k_percent, glm::dvec3(channel.value * 100.0, 0, 0));
    }
    if (curves.empty() && !driven) return;
    const std::size_t width = meshes_.shapes.size() + 1;
    auto times = times_of(curves, false, width);
    if (!times) return;
    document::Channel weights;
    if (times->steps) weights.interpolation = document::Interpolation::step;
    const std::size_t counted = times->times_s.size();
    if (!times->steps) add_knees(times->times_s);
    const std::size_t more = (times->times_s.size() - counted) * width;
    if (more > numbers_left_) {
      lost_ = true;
      return;
    }
    numbers_left_ -= more;
    if (counts_) return;
    weights.times_s = std::move(times->times_s);
    std::vector<double> values = meshes_.values;
    for (const double time_s : weights.times_s) {
      for (const FbxChannel& channel : meshes_.channels) channel.spread(channel_at(channel, time_s), values);
      weights.values.insert(weights.values.end(), values.begin(), values.end());
    }
    animation_.channels.push_back(std::move(weights));
  }

  /// Times of a model are never below 0: a take that begins there is moved as a whole, and of any other what lies
  /// before 0 is left out.
  void begin_at_zero() {
    double first = 0;
    for (const document::Channel& channel : animation_.channels) first = std::min(first, channel.times_s.front());
    if (first == 0.0) return;
    for (document::Channel& channel : animation_.channels) {
      if (take_.start_s() < 0.0 || channel.times_s.back() <= 0.0) {
        for (double& time_s : channel.times_s) time_s -= first;
        continue;
      }
      cut_before_zero(channel);
    }
  }
  static void cut_before_zero(document::Channel& channel) {
    std::vector<double>& times = channel.times_s;
    const std::size_t width = channel.values.size() / times.size();
    const auto after = static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), 0.0) - times.begin());
    if (after == 0) return;
    const std::size_t kept = after - 1;
    if (after < times.size() && channel.interpolation != document::Interpolation::step) {
      const double share = (0.0 - times[kept]) / (times[after] - times[kept]);
      for (std::size_t i = 0; i < width; ++i) {
        double& value = channel.values[kept * width + i];
        value += (channel.values[after * width + i] - value) * share;
      }
    }
    times[kept] = 0.0;
    if (after < times.size() && times[after] == 0.0) times[kept] = -1.0;
    const std::size_t drop = times[kept] < 0.0 ? after : kept;
    times.erase(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(drop));
    channel.values.erase(channel.values.begin(), channel.values.begin() + static_cast<std::ptrdiff_t>(drop * width));
  }

  const FbxScene& scene_;
  const FbxTake& take_;
  FbxPlaces& places_;
  const FbxJoints& joints_;
  const FbxMeshes& meshes_;
  std::size_t& numbers_left_;
  double rate_;
  bool counts_;  ///< how many numbers there are, and nothing more
  glm::dmat4 world_;
  std::map<std::int64_t, FbxNodeTransform> transforms_;
  document::Animation animation_;
  bool lost_ = false;
};

}  // namespace

std::vector<document::Animation> read_fbx_animations(const FbxScene& scene, const FbxTakes& takes, FbxPlaces& places,
                                                     const FbxJoints& joints, const FbxMeshes& meshes,
                                                     std::size_t most_numbers, std::vector<std::string>& notes) {
  const auto read = [&](double rate, bool counts, std::vector<document::Animation>& out) {
    std::size_t numbers_left = most_numbers;
    bool lost = false;
    for (const auto& [name, take] : takes) {
      TakeReader reader(scene, take, places, joints, meshes, rate, counts, numbers_left);
      document::Animation animation = reader.read();
      lost = lost || reader.lost();
      if (counts && lost) break;
      if (animation.channels.empty()) continue;
      animation.name = name;
      out.push_back(std::move(animation));
    }
    return !lost;
  };
  // Fewer moments in every curve where there are too many in all.
  std::vector<document::Animation> out;
  const double whole_rate = rate_of(scene.frames_per_second());
  double rate = whole_rate;
  while (rate > k_least_rate && !read(rate, true, out)) rate /= 4.0;
  if (!read(rate, false, out)) notes.emplace_back("keys were left out: there are too many for a file of this size");
  if (rate < whole_rate) notes.emplace_back("curves that bend over a long time have fewer keys than frames");
  return out;
}

}  // namespace penpose::io
