#include "core/io/gltf/internal/animation_hash.h"

#include <map>
#include <vector>

namespace penpose::io {

base::Hash128 hash_animation(const document::Animation& animation, std::span<const std::string> names) {
  std::map<std::string_view, std::size_t> columns;
  for (std::size_t i = 0; i < names.size(); ++i) columns.emplace(names[i], i);
  base::StateHash hash;
  std::vector<double> column;
  for (const document::Channel& channel : animation.channels) {
    hash.add(static_cast<std::uint64_t>(channel.target));
    hash.add(std::uint64_t{channel.joint});
    hash.add(static_cast<std::uint64_t>(channel.interpolation));
    hash.add(std::span<const double>(channel.times_s));
    if (channel.target != document::ChannelTarget::weights) {
      hash.add(std::span<const double>(channel.values));
      continue;
    }
    for (const auto& [name, index] : columns) {
      column.clear();
      bool moves = false;
      for (std::size_t at = index; at < channel.values.size(); at += names.size()) {
        column.push_back(channel.values[at]);
        moves = moves || column.back() != 0.0;
      }
      if (!moves) continue;
      hash.add(name);
      hash.add(std::span<const double>(column));
    }
  }
  return hash.digest();
}

}  // namespace penpose::io
