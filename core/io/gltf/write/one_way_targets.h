#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/rig/blend_shapes.h"

namespace penpose::io {

/// A target that takes a part of what another one should do. Programs show weights from 0 to 1 and cut all others off,
/// some of them silently (Blender's importer widens a shape key by the first key of an animation alone); so weights
/// below 0 are given to the same target turned round, and weights above 1 to the same target again.
struct OneWayTarget {
  std::size_t of = 0;  ///< number of the target that it helps
  bool turned = false;
  double from = 0;  ///< of the weight (turned: of its opposite): what lies between this and 1 more is its own
  rig::BlendShape shape;

  [[nodiscard]] double part(double weight) const;
};

/// The targets that are needed beside `targets` where their weights go from `low` to `high`. Weights that go more than
/// 8 beyond 0 to 1 are left as they are.
[[nodiscard]] std::vector<OneWayTarget> one_way_targets(std::span<const rig::BlendShape* const> targets,
                                                        std::span<const double> low, std::span<const double> high);

}  // namespace penpose::io
