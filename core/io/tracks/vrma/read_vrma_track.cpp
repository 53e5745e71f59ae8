#include <array>
#include <cmath>
#include <map>

#include "core/base/text/letters.h"
#include "core/base/text/utf8.h"
#include "core/document/humanoid_rest.h"
#include "core/geometry/rotation.h"
#include "core/io/gltf/read/internal/gltf_animations.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_nodes.h"
#include "core/io/gltf/vrm/vrm_extension.h"
#include "core/io/remedies.h"
#include "core/io/tracks/motion_track.h"
#include "core/io/tracks/track_formats.h"

namespace penpose::io {
namespace {

constexpr const char* k_pointer = "/extensions/VRMC_vrm_animation";
/// More than any avatar has.
constexpr std::size_t k_most_track_expressions = 1000;

class MotionReader {
 public:
  explicit MotionReader(GltfDocument& document) : document_(document), tree_(make_node_tree(document)) {}

  base::Result<MotionTrack> read() {
    const json::Json* extensions = json::find(document_.json, "extensions");
    const json::Json* own = extensions == nullptr ? nullptr : json::find(*extensions, "VRMC_vrm_animation");
    if (own == nullptr) {
      return base::Error{"the file is no VRM animation", "/extensions", "give a .vrma file, or a track of a face"};
    }
    const json::Json* version = json::find(*own, "specVersion");
    const std::string said =
        version != nullptr && version->is_string() ? version->get<std::string>() : std::string("none");
    if (!said.starts_with("1.")) {
      return base::Error{"the version of the VRM animation is " + base::valid_utf8(said) + ", not 1.0", k_pointer,
                         "export it as VRMC_vrm_animation 1.0"};
    }
    if (document_.model.animations.empty()) {
      return base::Error{"the file has no animation", "/animations", k_export_again};
    }
    if (document_.model.animations.size() > 1) {
      track_.notes.push_back("the first of " + std::to_string(document_.model.animations.size()) +
                             " animations is played");
    }
    index_channels();
    if (auto status = read_humanoid(); !status) return status.error();
    if (auto status = read_expressions(*own); !status) return status.error();
    if (auto status = read_gaze(*own); !status) return status.error();
    if (track_.bones.empty() && !track_.hips && track_.expressions.empty() && !track_.gaze) {
      return base::Error{"the animation moves no bone and no expression", "/animations/0", k_export_again};
    }
    return std::move(track_);
  }

 private:
  void index_channels() {
    const auto& channels = document_.model.animations[0].channels;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (channels[c].target_node >= 0)
        channels_.emplace(std::pair(channels[c].target_node, channels[c].target_path), c);
    }
  }

  /// The keys of a node's property; none where it is not animated.
  base::Result<std::optional<GltfKeys>> keys_of(std::size_t node, const char* path) {
    const auto found = channels_.find(std::pair(static_cast<int>(node), std::string(path)));
    if (found == channels_.end()) return std::optional<GltfKeys>();
    const tinygltf::Animation& animation = document_.model.animations[0];
    const auto& sampler = animation.samplers[static_cast<std::size_t>(animation.channels[found->second].sampler)];
    const bool rotation = std::string_view(path) == "rotation";
    auto keys = read_keys(document_, sampler, rotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3, 1,
                          "/animations/0/channels/" + std::to_string(found->second));
    if (!keys) return keys.error();
    if (keys->times_s.empty()) return std::optional<GltfKeys>();
    return std::optional<GltfKeys>(std::move(keys).value());
  }

  static document::Channel channel_of(document::ChannelTarget target, GltfKeys& keys) {
    return {target, 0, keys.interpolation, std::move(keys.times_s), std::move(keys.values)};
  }

  /// Where a node's parent stands in the world at rest.
  struct Placed {
    glm::dquat rotation{1, 0, 0, 0};
    glm::dmat4 matrix{1};
  };
  base::Result<Placed> parent_of(std::size_t node) {
    Placed placed;
    for (std::int32_t up = tree_.parent[node]; up >= 0; up = tree_.parent[static_cast<std::size_t>(up)]) {
      const auto transform = node_transform(document_, static_cast<std::size_t>(up));
      if (!transform) return transform.error();
      placed.rotation = document::unit_rotation(document::unit_rotation(transform->rotation) * placed.rotation);
      placed.matrix = geometry::compose(transform->translation, transform->rotation, transform->scale) * placed.matrix;
    }
    return placed;
  }

  base::Status read_humanoid() {
    std::vector<std::int32_t> nodes(document_.model.nodes.size());
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = static_cast<std::int32_t>(n);
    const document::Humanoid humanoid = vrm_humanoid(document_.json, nodes);
    for (std::size_t b = 0; b < document::k_human_bones; ++b) {
      const auto bone = static_cast<document::HumanBone>(b);
      const auto node = humanoid.joint(bone);
      if (!node) continue;
      auto turns = keys_of(*node, "rotation");
      if (!turns) return turns.error();
      const bool hips = bone == document::HumanBone::hips;
      if (!*turns && !hips) continue;
      const auto rest = node_transform(document_, *node);
      if (!rest) return rest.error();
      const auto parent = parent_of(*node);
      if (!parent) return parent.error();
      if (*turns) {
        BoneMotion motion{bone, channel_of(document::ChannelTarget::rotation, **turns)};
        normalise(motion.rotations, parent->rotation,
                  document::unit_rotation(parent->rotation * document::unit_rotation(rest->rotation)));
        track_.bones.push_back(std::move(motion));
      }
      if (!hips) continue;
      track_.hips_height = (parent->matrix * glm::dvec4(rest->translation, 1)).y;
      auto shifts = keys_of(*node, "translation");
      if (!shifts) return shifts.error();
      if (!*shifts) continue;
      track_.hips = channel_of(document::ChannelTarget::translation, **shifts);
      put_in_world(*track_.hips, parent->matrix);
    }
    return base::Done{};
  }

  /// N = P q inverse(W), with P = W inverse(L) the rotation of the parent. Linear in q, so that splines stay what they
  /// are.
  static void normalise(document::Channel& channel, const glm::dquat& parent, const glm::dquat& world) {
    const bool cubic = channel.interpolation == document::Interpolation::cubic_spline;
    for (std::size_t i = 0; i + 4 <= channel.values.size(); i += 4) {
      double* v = &channel.values[i];
      glm::dquat q(v[3], v[0], v[1], v[2]);
      if (!cubic) q = document::unit_rotation(q);
      const glm::dquat turned = parent * q * glm::conjugate(world);
      v[0] = turned.x;
      v[1] = turned.y;
      v[2] = turned.z;
      v[3] = turned.w;
    }
  }

  static void put_in_world(document::Channel& channel, const glm::dmat4& matrix) {
    const bool cubic = channel.interpolation == document::Interpolation::cubic_spline;
    for (std::size_t i = 0; i + 3 <= channel.values.size(); i += 3) {
      double* v = &channel.values[i];
      const bool tangent = cubic && i / 3 % 3 != 1;
      const glm::dvec4 moved = matrix * glm::dvec4(v[0], v[1], v[2], tangent ? 0 : 1);
      for (int axis = 0; axis < 3; ++axis) v[axis] = moved[axis];
    }
  }

  base::Status read_expressions(const json::Json& own) {
    const json::Json* expressions = json::find(own, "expressions");
    for (const char* group : {"preset", "custom"}) {
      const json::Json* members = expressions == nullptr ? nullptr : json::find(*expressions, group);
      if (members == nullptr || !members->is_object()) continue;
      for (const auto& [name, expression] : members->items()) {
        const auto node = node_of(expression);
        if (!node) {
          track_.notes.push_back("expression " + base::valid_utf8(name) + " is left out: it names no node");
          continue;
        }
        if (track_.expressions.size() == k_most_track_expressions) {
          track_.notes.emplace_back("expressions after the first 1,000 are left out");
          return base::Done{};
        }
        auto keys = keys_of(*node, "translation");
        if (!keys) return keys.error();
        if (!*keys) continue;
        ExpressionMotion motion{base::valid_utf8(name), channel_of(document::ChannelTarget::weights, **keys)};
        // The weight is x (VRMC_vrm_animation, "Expressions").
        std::vector<double>& values = motion.weights.values;
        for (std::size_t i = 0; 3 * i < values.size(); ++i) values[i] = values[3 * i];
        values.resize(values.size() / 3);
        track_.expressions.push_back(std::move(motion));
      }
    }
    return base::Done{};
  }

  base::Status read_gaze(const json::Json& own) {
    const json::Json* look = json::find(own, "lookAt");
    const auto node = look == nullptr ? std::nullopt : node_of(*look);
    if (!node) return base::Done{};
    auto keys = keys_of(*node, "rotation");
    if (!keys) return keys.error();
    if (!*keys) return base::Done{};
    track_.gaze = channel_of(document::ChannelTarget::rotation, **keys);
    return base::Done{};
  }

  [[nodiscard]] std::optional<std::size_t> node_of(const json::Json& owner) const {
    const json::Json* node = json::find(owner, "node");
    const auto count = static_cast<std::int64_t>(document_.model.nodes.size());
    const auto number = node == nullptr || count == 0 ? std::nullopt : json::whole_number(*node, 0, count - 1);
    return number ? std::optional(static_cast<std::size_t>(*number)) : std::nullopt;
  }

  GltfDocument& document_;
  NodeTree tree_;
  std::map<std::pair<int, std::string>, std::size_t> channels_;  ///< by node and path
  MotionTrack track_;
};

}  // namespace

bool looks_like_vrma(base::Bytes bytes) {
  if (!is_glb(bytes)) return false;
  // The JSON stands first; an extension of the root may come after all nodes.
  return base::as_text(bytes).find("\"VRMC_vrm_animation\"") != std::string_view::npos;
}

base::Result<MotionTrack> read_vrma(base::Bytes bytes) {
  auto document = open_gltf(bytes, {});
  if (!document) return document.error();
  return MotionReader(*document).read();
}

TrackFormat vrma_format() {
  return {"vrma", 20, true, [](const TrackText& text) { return looks_like_vrma(base::as_bytes(text.text)); },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_vrma(bytes)); }};
}

}  // namespace penpose::io
