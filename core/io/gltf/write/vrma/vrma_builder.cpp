#include "core/io/gltf/write/vrma/vrma_builder.h"

#include <algorithm>
#include <array>

namespace penpose::io {

VrmaBuilder::VrmaBuilder() {
  builder_.root["asset"] = {{"version", "2.0"}, {"generator", "penpose"}};
  builder_.root["extensionsUsed"] = json::Json::array({"VRMC_vrm_animation"});
}

std::size_t VrmaBuilder::add_node(std::string name, const glm::dvec3& place, std::optional<std::size_t> parent) {
  const std::size_t node = nodes_.size();
  json::Json object = {{"name", std::move(name)}};
  if (place != glm::dvec3(0)) object["translation"] = float_row(place);
  nodes_.push_back(std::move(object));
  if (parent) {
    nodes_[*parent]["children"].push_back(node);
  } else {
    scene_.push_back(node);
  }
  return node;
}

void VrmaBuilder::add_keys(const std::vector<double>& times_s, document::Interpolation interpolation,
                           const std::vector<float>& values, const char* type, std::size_t node, const char* path) {
  constexpr std::array<const char*, 3> k_interpolations = {"STEP", "LINEAR", "CUBICSPLINE"};
  const std::vector<float> times(times_s.begin(), times_s.end());
  auto [input, is_new] = inputs_.try_emplace(times, 0);
  if (is_new) input->second = builder_.add_floats(times, "SCALAR", BufferUse::plain, true);
  samplers_.push_back({{"input", input->second},
                       {"interpolation", k_interpolations[static_cast<std::size_t>(interpolation)]},
                       {"output", builder_.add_floats(values, type, BufferUse::plain, false)}});
  channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
}

base::Result<std::vector<std::uint8_t>> VrmaBuilder::finish(const std::string& name) {
  for (json::Json& node : nodes_) builder_.add("nodes", std::move(node));
  builder_.root["scenes"] = json::Json::array({{{"nodes", scene_}}});
  builder_.root["scene"] = 0;
  json::Json object = {{"channels", std::move(channels_)}, {"samplers", std::move(samplers_)}};
  if (!name.empty()) object["name"] = name;
  builder_.add("animations", std::move(object));
  builder_.root["extensions"]["VRMC_vrm_animation"] = std::move(own);
  return builder_.finish();
}

json::Json float_row(const glm::dvec3& v) {
  return {static_cast<double>(static_cast<float>(v.x)), static_cast<double>(static_cast<float>(v.y)),
          static_cast<double>(static_cast<float>(v.z))};
}

std::vector<double> key_times(const std::vector<const document::Channel*>& channels) {
  std::vector<double> times;
  for (const document::Channel* channel : channels) {
    const auto& keys = channel->times_s;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      times.push_back(keys[k]);
      for (int i = 1; channel->interpolation == document::Interpolation::cubic_spline && k + 1 < keys.size() && i < 8;
           ++i)
        times.push_back(keys[k] + (keys[k + 1] - keys[k]) * i / 8.0);
    }
  }
  for (double& time : times) time = static_cast<double>(static_cast<float>(time));
  std::stable_sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace penpose::io
