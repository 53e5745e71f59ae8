#include "core/io/gltf/read/internal/gltf_animations.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

using Keys = GltfKeys;

class AnimationReader {
 public:
  AnimationReader(GltfDocument& document, const GltfMeshes& meshes, const GltfShapes& shapes,
                  const std::vector<std::int32_t>& joint_of_node)
      : document_(document), meshes_(meshes), shapes_(shapes), joint_of_node_(joint_of_node) {}

  std::vector<document::Animation> read(std::vector<std::size_t>& from) {
    std::vector<document::Animation> animations;
    for (std::size_t a = 0; a < document_.model.animations.size(); ++a) {
      document::Animation animation;
      animation.name = document_.model.animations[a].name;
      read_channels(a, animation);
      if (animation.channels.empty()) continue;
      animations.push_back(std::move(animation));
      from.push_back(a);
    }
    if (left_out_) document_.notes.emplace_back("animation of nodes that carry no vertices was left out");
    if (unreadable_) {
      document_.notes.push_back("animation that cannot be read was left out: " + unreadable_->place + ": " +
                                unreadable_->what);
    }
    if (other_times_) {
      document_.notes.emplace_back("weights animated at other times than those of another mesh were left out");
    }
    return animations;
  }

 private:
  void read_channels(std::size_t a, document::Animation& animation) {
    const tinygltf::Animation& source = document_.model.animations[a];
    std::optional<std::size_t> weights_channel;
    filled_.clear();
    for (std::size_t c = 0; c < source.channels.size(); ++c) {
      const std::string pointer = "/animations/" + std::to_string(a) + "/channels/" + std::to_string(c);
      if (source.channels[c].target_node < 0) continue;
      const auto read = read_channel(a, source.channels[c], pointer, weights_channel, animation);
      if (!read && !unreadable_) unreadable_ = read.error();
    }
  }

  base::Status read_channel(std::size_t a, const tinygltf::AnimationChannel& channel, const std::string& pointer,
                            std::optional<std::size_t>& weights_channel, document::Animation& animation) {
    const auto node = static_cast<std::size_t>(channel.target_node);
    const auto sampler_index = static_cast<std::size_t>(channel.sampler);
    const tinygltf::AnimationSampler& sampler = document_.model.animations[a].samplers[sampler_index];
    if (channel.target_path == "weights") {
      const auto part = part_of(node);
      if (!part) {
        left_out_ = true;
        return base::Done{};
      }
      auto keys = read_keys(document_, sampler, TINYGLTF_TYPE_SCALAR, shapes_.of_target[*part].size(), pointer);
      if (!keys) return keys.error();
      take_spline(a, sampler_index, shapes_.of_target[*part].size(), *keys);
      drop_added(a, sampler_index, *keys);
      return add_weights(*keys, *part, weights_channel, animation);
    }
    const auto target = path(channel.target_path);
    if (!target) return base::Error{"the path \"" + channel.target_path + "\" is not known", pointer, k_export_again};
    if (joint_of_node_[node] < 0) {
      left_out_ = true;
      return base::Done{};
    }
    const bool rotation = *target == document::ChannelTarget::rotation;
    auto keys = read_keys(document_, sampler, rotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3, 1, pointer);
    if (!keys) return keys.error();
    animation.channels.push_back({*target, static_cast<std::uint32_t>(joint_of_node_[node]), keys->interpolation,
                                  std::move(keys->times_s), std::move(keys->values)});
    return base::Done{};
  }

  static std::optional<document::ChannelTarget> path(const std::string& name) {
    if (name == "translation") return document::ChannelTarget::translation;
    if (name == "rotation") return document::ChannelTarget::rotation;
    if (name == "scale") return document::ChannelTarget::scale;
    return std::nullopt;
  }

  /// The first part below a node that has targets.
  [[nodiscard]] std::optional<std::size_t> part_of(std::size_t node) const {
    for (std::size_t i = 0; i < meshes_.origins.size(); ++i) {
      if (meshes_.origins[i].node == node && !shapes_.of_target[i].empty()) return i;
    }
    return std::nullopt;
  }

  /// Takes the spline that the sampler's keys are straight lines of, where the file has a sound one (dense_keys.h).
  void take_spline(std::size_t a, std::size_t sampler, std::size_t targets, Keys& keys) const {
    const json::Json* extras = json::find(document_.json["animations"][a]["samplers"][sampler], "extras");
    const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
    const json::Json* spline = own == nullptr ? nullptr : json::find(*own, "spline");
    const json::Json* times = spline == nullptr ? nullptr : json::find(*spline, "times");
    const json::Json* values = spline == nullptr ? nullptr : json::find(*spline, "values");
    if (times == nullptr || values == nullptr || !times->is_array() || !values->is_array()) return;
    if (times->empty() || values->size() != 3 * times->size() * targets) return;
    Keys whole{document::Interpolation::cubic_spline, {}, {}};
    const auto number = [](const json::Json& json) {
      const double value = json.is_number() ? json.get<double>() : std::nan("");
      return static_cast<double>(static_cast<float>(value));
    };
    for (const json::Json& time : *times) {
      const double at = number(time);
      if (!(at >= 0) || !std::isfinite(at) || (!whole.times_s.empty() && !(at > whole.times_s.back()))) return;
      whole.times_s.push_back(at);
    }
    for (const json::Json& value : *values) {
      whole.values.push_back(number(value));
      if (!std::isfinite(whole.values.back())) return;
    }
    // Of another clip: somebody has changed the keys since.
    if (keys.times_s.empty() || whole.times_s.front() != keys.times_s.front() ||
        whole.times_s.back() != keys.times_s.back())
      return;
    keys = std::move(whole);
  }

  /// Drops keys that were added for other programs alone (dense_keys.h).
  void drop_added(std::size_t a, std::size_t sampler, Keys& keys) const {
    const json::Json* extras = json::find(document_.json["animations"][a]["samplers"][sampler], "extras");
    const json::Json* own = extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
    const json::Json* added = own == nullptr ? nullptr : json::find(*own, "added");
    if (added == nullptr || !added->is_array() || keys.times_s.empty()) return;
    std::vector<bool> drop(keys.times_s.size(), false);
    for (const json::Json& key : *added) {
      const auto number = json::whole_number(key, 1, static_cast<std::int64_t>(drop.size()) - 2);
      if (number) drop[static_cast<std::size_t>(*number)] = true;
    }
    const std::size_t run = keys.values.size() / keys.times_s.size();
    Keys kept{keys.interpolation, {}, {}};
    for (std::size_t k = 0; k < drop.size(); ++k) {
      if (drop[k]) continue;
      kept.times_s.push_back(keys.times_s[k]);
      const auto begin = keys.values.begin() + static_cast<std::ptrdiff_t>(k * run);
      kept.values.insert(kept.values.end(), begin, begin + static_cast<std::ptrdiff_t>(run));
    }
    keys = std::move(kept);
  }

  /// Spreads keys of the targets of one mesh over the one channel of all shapes.
  base::Status add_weights(const Keys& keys, std::size_t part, std::optional<std::size_t>& channel_index,
                           document::Animation& animation) {
    const std::size_t shapes = shapes_.shapes.size();
    const bool cubic = keys.interpolation == document::Interpolation::cubic_spline;
    const std::size_t rows = keys.times_s.size() * (cubic ? 3 : 1);
    if (!channel_index) {
      if (rows * shapes > document_.budget) {
        return base::Error{"the file unfolds to far more numbers than it has bytes", "/animations",
                           "it is damaged or hostile; export it again"};
      }
      document_.budget -= rows * shapes;
      channel_index = animation.channels.size();
      document::Channel& made = animation.channels.emplace_back();
      made.interpolation = keys.interpolation;
      made.times_s = keys.times_s;
      made.values.resize(rows * shapes, 0.0);
      for (std::size_t row = 0; row < rows; ++row) {
        // Shapes that no mesh animates hold their pose; their tangents are flat.
        if (cubic && row % 3 != 1) continue;
        for (std::size_t s = 0; s < shapes; ++s) {
          made.values[row * shapes + s] = static_cast<double>(static_cast<float>(shapes_.values[s]));
        }
      }
    }
    document::Channel& channel = animation.channels[*channel_index];
    if (channel.interpolation != keys.interpolation || channel.times_s != keys.times_s) {
      other_times_ = true;
      return base::Done{};
    }
    const auto& of_target = shapes_.of_target[part];
    for (std::size_t k = 0; k < of_target.size(); ++k) {
      if (!filled_.insert(of_target[k]).second) continue;
      for (std::size_t row = 0; row < rows; ++row) {
        channel.values[row * shapes + of_target[k]] = keys.values[row * of_target.size() + k];
      }
    }
    return base::Done{};
  }

  GltfDocument& document_;
  const GltfMeshes& meshes_;
  const GltfShapes& shapes_;
  const std::vector<std::int32_t>& joint_of_node_;
  std::set<std::size_t> filled_;  ///< shapes that the weights channel of this animation already drives
  bool left_out_ = false;
  bool other_times_ = false;
  std::optional<base::Error> unreadable_;  ///< the first channel that cannot be read
};

}  // namespace

base::Result<GltfKeys> read_keys(GltfDocument& document, const tinygltf::AnimationSampler& sampler, int type,
                                 std::size_t per_key, const std::string& pointer) {
  GltfKeys keys;
  if (sampler.interpolation == "STEP") {
    keys.interpolation = document::Interpolation::step;
  } else if (sampler.interpolation == "CUBICSPLINE") {
    keys.interpolation = document::Interpolation::cubic_spline;
  } else if (!sampler.interpolation.empty() && sampler.interpolation != "LINEAR") {
    return base::Error{"the interpolation \"" + sampler.interpolation + "\" is not known", pointer, k_export_again};
  }
  const auto times =
      read_elements(document, sampler.input, {.type = TINYGLTF_TYPE_SCALAR, .float_only = true, .needs_data = true});
  if (!times) return times.error();
  // Keys at the time of the one before them, or before it, are never reached.
  std::vector<bool> reached;
  for (const float number : times->dense()) {
    const auto time = static_cast<double>(number);
    reached.push_back(time >= 0 && std::isfinite(time) && (keys.times_s.empty() || time > keys.times_s.back()));
    if (reached.back()) keys.times_s.push_back(time);
  }
  if (keys.times_s.empty()) {
    return base::Error{"no key has a time from zero on", accessor_pointer(sampler.input), k_export_again};
  }
  const std::size_t run = per_key * (keys.interpolation == document::Interpolation::cubic_spline ? 3 : 1);
  const auto values = read_elements(document, sampler.output, {.type = type, .count = reached.size() * run});
  if (!values) return values.error();
  const std::vector<float> numbers = values->dense();
  const std::size_t width = run * values->components;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!reached[i / width]) continue;
    if (!std::isfinite(numbers[i])) {
      return base::Error{"a key has a value that is not a finite number", accessor_pointer(sampler.output),
                         k_export_again};
    }
    keys.values.push_back(static_cast<double>(numbers[i]));
  }
  const std::string note = "keys of animations that come no later than those before them were left out";
  if (keys.times_s.size() < reached.size() &&
      std::find(document.notes.begin(), document.notes.end(), note) == document.notes.end())
    document.notes.push_back(note);
  return keys;
}

std::vector<document::Animation> read_animations(GltfDocument& document, const GltfMeshes& meshes,
                                                 const GltfShapes& shapes,
                                                 const std::vector<std::int32_t>& joint_of_node,
                                                 std::vector<std::size_t>& from) {
  return AnimationReader(document, meshes, shapes, joint_of_node).read(from);
}

}  // namespace penpose::io
