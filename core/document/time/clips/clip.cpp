#include "core/document/time/clips/clip.h"

#include <algorithm>
#include <utility>

#include "core/document/time/timeline_animation.h"

namespace penpose::document {
namespace {

/// Whether some neighbouring controls have the same keys in both.
bool same_keys(const Timeline& a, const Timeline& b, std::size_t first, std::size_t count) {
  for (std::size_t p = first; p < first + count; ++p) {
    std::size_t at = 0;
    const auto next = [&](const Timeline& timeline, std::size_t from) {
      while (from < timeline.keys.size() && !timeline.keys[from].controls.has(p)) ++from;
      return from;
    };
    std::size_t other = next(b, 0);
    for (at = next(a, 0); at < a.keys.size() && other < b.keys.size();
         at = next(a, at + 1), other = next(b, other + 1)) {
      const PoseKey& one = a.keys[at];
      const PoseKey& two = b.keys[other];
      if (one.time_s != two.time_s || one.pose[p] != two.pose[p] || !(one.controls[p] == two.controls[p])) return false;
    }
    if (at < a.keys.size() || other < b.keys.size()) return false;
  }
  return true;
}

/// Of the rotation of a joint, the number of the first of its three parameters in the skeleton.
std::optional<std::size_t> parameter_of(const rig::Skeleton& skeleton, std::uint32_t joint) {
  for (std::size_t p = 0; p < skeleton.parameters().size(); p += 3) {
    if (skeleton.joint_of(p) == joint) return p;
  }
  return std::nullopt;
}

}  // namespace

Animation with_keys(const Model& model, const Animation& animation, const Timeline& opened, const Timeline& timeline) {
  const std::size_t weights = weight_count(model);
  const auto is_changed = [&](const Channel& channel) {
    if (channel.target == ChannelTarget::weights) return !same_keys(opened, timeline, 0, weights);
    if (channel.target != ChannelTarget::rotation || !model.skeleton) return false;
    const auto first = parameter_of(*model.skeleton, channel.joint);
    return first && !same_keys(opened, timeline, weights + *first, 3);
  };
  const auto drives_the_same = [](const Channel& a, const Channel& b) {
    return a.target == b.target && (a.target == ChannelTarget::weights || a.joint == b.joint);
  };
  Animation made = animation;
  std::erase_if(made.channels, is_changed);
  for (Channel& channel : to_animation(model, timeline).channels) {
    const bool kept = std::any_of(made.channels.begin(), made.channels.end(),
                                  [&](const Channel& other) { return drives_the_same(channel, other); });
    if (!kept && is_changed(channel)) made.channels.push_back(std::move(channel));
  }
  return made;
}

}  // namespace penpose::document
