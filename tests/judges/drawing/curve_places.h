#pragma once

#include <span>
#include <vector>

#include "core/portrait/feature_curve.h"

namespace penpose::judges::drawn {

/// Where the points of feature curves are: one run a curve.
using CurvePlaces = std::vector<std::vector<geometry::ModelPoint>>;

/// `positions`: of all vertices of the rig that the curves lie on.
[[nodiscard]] CurvePlaces places_of(std::span<const portrait::FeatureCurve> curves,
                                    std::span<const geometry::ModelPoint> positions);

/// The largest distance between vertices of two poses.
[[nodiscard]] double largest_move(std::span<const geometry::ModelPoint> from, std::span<const geometry::ModelPoint> to);

}  // namespace penpose::judges::drawn
