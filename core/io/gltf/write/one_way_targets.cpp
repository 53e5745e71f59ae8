#include "core/io/gltf/write/one_way_targets.h"

#include <algorithm>
#include <set>

namespace penpose::io {

double OneWayTarget::part(double weight) const { return std::clamp((turned ? -weight : weight) - from, 0.0, 1.0); }

std::vector<OneWayTarget> one_way_targets(std::span<const rig::BlendShape* const> targets, std::span<const double> low,
                                          std::span<const double> high) {
  constexpr double k_most = 8;
  std::set<std::string> taken;
  for (const rig::BlendShape* target : targets) taken.insert(target->parameter.name);
  std::vector<OneWayTarget> result;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    if (!(low[t] >= -k_most) || !(high[t] <= 1 + k_most)) continue;
    const auto add = [&](bool turned, double from) {
      OneWayTarget& one = result.emplace_back(OneWayTarget{t, turned, from, *targets[t]});
      std::string name = targets[t]->parameter.name + (turned ? "~turned" : "~more");
      if (from > (turned ? 0 : 1)) name += std::to_string(static_cast<int>(from));
      while (!taken.insert(name).second) name += "~";
      one.shape.parameter = {name, 0, 0, 1};
      for (glm::vec3& delta : one.shape.deltas) delta *= turned ? -1.0F : 1.0F;
      for (glm::vec3& delta : one.shape.normal_deltas) delta *= turned ? -1.0F : 1.0F;
    };
    for (double from = 0; low[t] < -from; ++from) add(true, from);
    for (double from = 1; high[t] > from; ++from) add(false, from);
  }
  return result;
}

}  // namespace penpose::io
