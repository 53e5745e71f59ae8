#include "core/rig/rig.h"

#include <algorithm>

namespace penpose::rig {

Pose rest_pose(const Rig& rig) {
  Pose pose;
  pose.reserve(rig.parameters().size());
  for (const Parameter& parameter : rig.parameters()) pose.push_back(parameter.rest);
  return pose;
}

std::optional<std::size_t> find_parameter(std::span<const Parameter> parameters, std::string_view name) {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const Parameter& p) { return p.name == name; });
  if (found == parameters.end()) return std::nullopt;
  return static_cast<std::size_t>(found - parameters.begin());
}

}  // namespace penpose::rig
