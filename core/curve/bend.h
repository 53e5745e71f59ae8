#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::curve {

using geometry::PxPoint;

/// How far along a line a pull acts to either side, as a share of its length.
inline constexpr double k_usual_reach = 0.35;

/// The share of a pull that acts on each point of a line: 1 at the grabbed place, falling smoothly along the line to 0
/// at `reach` of its length to either side, (1 - x^2)^2 with x the share of that distance. On a closed line the shorter
/// way round counts. `reach` 0: 1 everywhere. `held`: the grabbed place, px along the line.
[[nodiscard]] std::vector<double> pull_weights(std::span<const PxPoint> line, double held, double reach, bool closed);

/// The place on a line nearest to a point, in px along the line.
[[nodiscard]] double nearest_along(std::span<const PxPoint> line, PxPoint to);
/// The same with a given cumulative_length of the line.
[[nodiscard]] double nearest_along(std::span<const PxPoint> line, std::span<const double> cumulative, PxPoint to);

/// A line pulled at the place nearest to `at`. A line of few points gets more, so that it bends. Nothing for a line of
/// no length.
[[nodiscard]] std::optional<std::vector<PxPoint>> bent(std::span<const PxPoint> line, PxPoint at, PxPoint by,
                                                       double reach, bool closed);

}  // namespace penpose::curve
