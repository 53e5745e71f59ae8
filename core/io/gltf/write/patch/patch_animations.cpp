#include "core/io/gltf/write/patch/patch_animations.h"

#include <algorithm>
#include <map>
#include <string>

#include "core/io/gltf/internal/animation_hash.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/write/internal/glb_animations.h"

namespace penpose::io {
namespace {

std::vector<articulation::CorrectionSketch> corrections_of(
    const std::shared_ptr<const articulation::Corrections>& corrections) {
  std::vector<articulation::CorrectionSketch> sketches;
  for (std::size_t i = 0; corrections && i < corrections->size(); ++i) {
    sketches.push_back(corrections->all()[i]->drawn);
  }
  return sketches;
}

bool moves_weights(const document::Animation& animation) {
  return std::any_of(animation.channels.begin(), animation.channels.end(),
                     [](const auto& channel) { return channel.target == document::ChannelTarget::weights; });
}

}  // namespace

void PatchAnimations::compare() {
  std::vector<std::string> names;
  for (std::size_t w = 0; w < state_.width(); ++w) names.push_back(state_.model.rig->parameters()[w].name);
  const bool corrected = corrections_of(state_.model.corrections) != corrections_of(state_.source.corrections);
  std::vector<bool> taken(state_.source.animations.size(), false);
  for (const document::Animation& animation : state_.model.animations) {
    Fate& fate = fates_.emplace_back();
    const base::Hash128 hash = hash_animation(animation, names);
    for (std::size_t i = 0; i < taken.size() && !fate.from; ++i) {
      if (!taken[i] && state_.source.animations[i].hash == hash && state_.source.animations[i].name == animation.name)
        fate.from = i;
    }
    fate.kept =
        fate.from && !(corrected && moves_weights(animation)) && !moves_any(animation, state_.targets.reshaped());
    if (fate.from) taken[*fate.from] = true;
  }
  for (std::size_t a = 0; a < fates_.size(); ++a) {
    for (std::size_t i = 0; i < taken.size() && !fates_[a].from; ++i) {
      if (taken[i] || state_.source.animations[i].name != state_.model.animations[a].name) continue;
      fates_[a].from = i;
      taken[i] = true;
    }
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (!taken[i]) removed_.insert(state_.source.animations[i].index);
  }
}

bool PatchAnimations::moves_any(const document::Animation& animation, const std::vector<bool>& columns) const {
  for (const document::Channel& channel : animation.channels) {
    if (channel.target != document::ChannelTarget::weights) continue;
    for (std::size_t i = 0; i < channel.values.size(); ++i) {
      if (columns[i % state_.width()] && channel.values[i] != 0.0) return true;
    }
  }
  return false;
}

void PatchAnimations::find_weights() {
  rewritten_ = state_.model;
  rewritten_.animations.clear();
  for (std::size_t a = 0; a < fates_.size(); ++a) {
    if (!fates_[a].kept) rewritten_.animations.push_back(state_.model.animations[a]);
  }
  std::vector<bool> posed(state_.morphs.all().size(), true);
  for (std::size_t w = 0; w < state_.width(); ++w) posed[w] = state_.targets.is_posed(w);
  state_.weights.emplace(rewritten_, state_.morphs, posed);
  std::vector<bool> used = posed;
  for (std::size_t w = 0; w < state_.width(); ++w) {
    std::vector<bool> one(state_.width(), false);
    one[w] = true;
    used[w] = used[w] || std::any_of(rewritten_.animations.begin(), rewritten_.animations.end(),
                                     [&](const auto& animation) { return moves_any(animation, one); });
  }
  state_.posed = std::move(posed);
  state_.targets.add_new(*state_.weights, used);
}

std::vector<std::size_t> PatchAnimations::write(const PatchJoints& joints) {
  const std::vector<WeightNode> nodes = PatchWeights(state_).nodes();
  const auto node_of_joint = [&](std::size_t joint) { return joints.node_of(joint); };
  GlbAnimations writer(*state_.weights, nodes, node_of_joint, state_.builder);
  std::vector<std::size_t> order;
  std::size_t rewritten = 0;
  for (std::size_t a = 0; a < fates_.size(); ++a) {
    const Fate& fate = fates_[a];
    if (fate.kept) {
      order.push_back(state_.source.animations[*fate.from].index);
      continue;
    }
    const document::Animation& animation = rewritten_.animations[rewritten++];
    json::Json object = json::Json::object();
    json::Json channels = json::Json::array();
    json::Json samplers = json::Json::array();
    if (fate.from) {
      object = state_.builder.root["animations"][state_.source.animations[*fate.from].index];
      keep_channels(object, nodes, channels, samplers);
    }
    writer.write(animation, channels, samplers);
    if (channels.empty()) continue;
    state_.changed = true;
    object["channels"] = std::move(channels);
    object["samplers"] = std::move(samplers);
    if (!animation.name.empty()) object["name"] = animation.name;
    const double fps = GlbAnimations::rate_of(animation);
    if (fps > 0) own_extras_of(object)["fps"] = fps;
    if (fate.from) {
      const std::size_t index = state_.source.animations[*fate.from].index;
      state_.builder.root["animations"][index] = std::move(object);
      order.push_back(index);
    } else {
      order.push_back(state_.builder.add("animations", std::move(object)));
    }
  }
  between_error_ = writer.between_error();
  remove_animations(order);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i] < order[i - 1]) return order;
  }
  return {};
}

/// Channels of an animation that the model does not have: of nodes that are no joints, of what extensions drive.
void PatchAnimations::keep_channels(const json::Json& object, const std::vector<WeightNode>& nodes,
                                    json::Json& channels, json::Json& samplers) const {
  for (const json::Json& one : object["channels"]) {
    const json::Json* node = json::find(one["target"], "node");
    const json::Json* path = json::find(one["target"], "path");
    const auto is_moved = [&](const std::optional<std::size_t>& other) {
      return node != nullptr && other == node->get<std::size_t>();
    };
    const bool of_weights = path != nullptr && *path == "weights";
    const auto& joints = state_.source.nodes;
    const bool of_model =
        of_weights ? std::any_of(nodes.begin(), nodes.end(), [&](const auto& other) { return is_moved(other.node); })
                   : std::any_of(joints.begin(), joints.end(), is_moved);
    if (of_model) continue;
    json::Json channel = one;
    samplers.push_back(object["samplers"][channel["sampler"].get<std::size_t>()]);
    channel["sampler"] = samplers.size() - 1;
    channels.push_back(std::move(channel));
  }
}

void PatchAnimations::remove_animations(std::vector<std::size_t>& order) {
  if (removed_.empty()) return;
  state_.changed = true;
  json::Json left = json::Json::array();
  std::map<std::size_t, std::size_t> place;
  const json::Json& all = state_.builder.root["animations"];
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (removed_.contains(i)) continue;
    place[i] = left.size();
    left.push_back(all[i]);
  }
  for (std::size_t& index : order) index = place[index];
  if (left.empty()) {
    state_.builder.root.erase("animations");
  } else {
    state_.builder.root["animations"] = std::move(left);
  }
}

}  // namespace penpose::io
