#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/document/drawing/pose_curve.h"

namespace penpose::document {

/// The target of a reference from a drawn line (method, section 1: order, spacing, lifting). `reference` are the
/// positions of the reference's points now. `pressure`: one a point of the line, or empty for 1 everywhere. Errors: an
/// invalid camera, those of pair_target, a wrong number of pressures.
[[nodiscard]] base::Result<DrawnTarget> make_target(std::span<const geometry::ModelPoint> reference, const View& view,
                                                    std::span<const curve::PxPoint> line,
                                                    std::span<const double> pressure);

/// A target with the part along a stroke redrawn in a view: from the place nearest to the stroke's start to the place
/// nearest to its end, in either direction. Points outside of that part keep their exact positions; where the stroke
/// begins or ends off the line, it is blended into it. The pressures stay as they were. `reference` as in make_target.
/// Errors: an invalid camera, a target behind it, a stroke of no length or one that runs along no part of the target.
[[nodiscard]] base::Result<DrawnTarget> drawn_over(const DrawnTarget& before,
                                                   std::span<const geometry::ModelPoint> reference, const View& view,
                                                   std::span<const curve::PxPoint> stroke);

/// The points of a target that a change of it left exactly where they were, one flag a point; empty: none, or all of
/// them.
[[nodiscard]] std::vector<bool> untouched(const DrawnTarget& before, const DrawnTarget& after);

/// True when two lines come within a distance of each other. A line of one point is that point.
[[nodiscard]] bool come_near(std::span<const curve::PxPoint> a, std::span<const curve::PxPoint> b, double distance_px);

}  // namespace penpose::document
