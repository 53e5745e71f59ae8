#pragma once

#include <optional>
#include <span>

#include "core/articulation/sketch.h"

namespace penpose::app {

/// A ball that points lie around, for a deformer that slides over it: its middle is that of the sphere which fits them
/// best (least squares of |p|² + a·p + b), its radius a little less than the nearest point, so that no point belongs to
/// the ball itself. Nothing for fewer than four points, or points on a plane.
[[nodiscard]] std::optional<articulation::Sphere> fitted_ball(std::span<const geometry::ModelPoint> points);

}  // namespace penpose::app
