#include "core/poses/sides.h"

#include <algorithm>

#include "core/articulation/mirror.h"
#include "core/poses/take_pose.h"

namespace penpose::poses {
std::vector<std::size_t> side_pairs(std::span<const rig::Parameter> parameters) {
  std::vector<std::size_t> pairs(parameters.size(), k_no_pair);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (pairs[i] != k_no_pair) continue;
    const auto other = rig::find_parameter(parameters, articulation::mirrored_name(parameters[i].name));
    // Both name each other, or there would be three of a pair.
    if (!other || *other == i || pairs[*other] != k_no_pair ||
        articulation::mirrored_name(parameters[*other].name) != parameters[i].name) {
      continue;
    }
    pairs[i] = *other;
    pairs[*other] = i;
  }
  return pairs;
}

rig::Pose flipped(std::span<const rig::Parameter> parameters, std::span<const std::size_t> pairs, const rig::Pose& pose,
                  std::size_t count) {
  rig::Pose out = pose;
  for (std::size_t i = 0; i < std::min(count, pose.size()); ++i) {
    if (pairs[i] != k_no_pair) out[i] = fitted(parameters[i], pose[pairs[i]]);
  }
  return out;
}

std::vector<document::NamedValue> shared_values(const document::Model& model, const rig::Pose& from,
                                                const std::vector<document::NamedValue>& values,
                                                const PoseShare& share) {
  const auto parameters = model.rig->parameters();
  const rig::Pose to = with_values(*model.rig, from, values);
  const auto pairs = side_pairs(parameters);
  const rig::Pose turned = share.mirrored ? flipped(parameters, pairs, to, document::weight_count(model)) : to;
  std::vector<bool> named(parameters.size(), false);
  for (const document::NamedValue& one : values) {
    const auto number = rig::find_parameter(parameters, one.name);
    if (!number) continue;
    named[*number] = true;
    if (share.mirrored && pairs[*number] != k_no_pair) named[pairs[*number]] = true;
  }
  std::vector<document::NamedValue> out;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!named[i]) continue;
    const double value = share.amount == 1 ? turned[i] : from[i] + share.amount * (turned[i] - from[i]);
    out.push_back({parameters[i].name, fitted(parameters[i], value)});
  }
  return out;
}

}  // namespace penpose::poses
