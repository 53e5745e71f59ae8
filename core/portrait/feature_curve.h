#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/posing/problem.h"

namespace penpose::portrait {

/// A line of the model that an artist would draw: a lip, a lid, a brow, the jaw.
struct FeatureCurve {
  std::string name;                        ///< unique within a model
  std::vector<posing::CurvePoint> points;  ///< at least two, in order along the curve
};

/// The vertex that bears most of a point.
[[nodiscard]] inline std::uint32_t nearest_vertex(const posing::CurvePoint& point) {
  const auto most = std::max_element(point.weight.begin(), point.weight.end()) - point.weight.begin();
  return point.vertex[static_cast<std::size_t>(most)];
}

/// The name of each curve.
[[nodiscard]] inline std::vector<std::string> names_of(std::span<const FeatureCurve> curves) {
  std::vector<std::string> names;
  for (const FeatureCurve& curve : curves) names.push_back(curve.name);
  return names;
}

}  // namespace penpose::portrait
