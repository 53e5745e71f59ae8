#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/joints/body.h"

namespace penpose::joints {

/// Neighbouring joints of a chain that bend alike, each by the same rotation about an axis of the world: lines of
/// action bend the spine evenly, and a tail curls.
struct Run {
  std::vector<std::size_t> joints;  ///< from the root on, at least two
  bool planar = false;              ///< the first axis is the view's direction
  double across = 1;                ///< as of a turn
  glm::dmat3 axes{1};               ///< in the world at the start: two that bend it and one along it
};

/// All runs within a chain (joints, ascending), shorter ones first; none on limbs with a hinge. Joints from which other
/// limbs part are no part of a run that would begin there: what they turn is more than what was drawn. Long chains give
/// coarser runs. `view`: the direction in which the one picture looks, or nothing where there are several.
[[nodiscard]] std::vector<Run> runs_of(const Body& body, std::span<const Place> start,
                                       std::span<const std::size_t> chain, const std::optional<ModelVector>& view);

}  // namespace penpose::joints
