#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/document/drawing/pose_curve.h"

namespace penpose::document {

/// Where a reference should go, from a drawn line (method, section 1: order, spacing, lifting). `reference` are the
/// positions of the reference's points now. `pressure`: one a point of the line, or empty for 1 everywhere. Errors: a
/// camera that cannot be, those of pair_target, a number of pressures that does not fit.
[[nodiscard]] base::Result<DrawnTarget> make_target(std::span<const geometry::ModelPoint> reference, const View& view,
                                                    std::span<const curve::PxPoint> line,
                                                    std::span<const double> pressure);

/// A target of which the part that a stroke runs along is drawn anew in a view: from the place nearest to the stroke's
/// start to the place nearest to its end, whichever way it was drawn. What lies outside of that part stays where it is,
/// to the bit; where the stroke begins or ends beside the line it is led over to it. How hard was pressed stays as it
/// was. `reference` as in make_target. Errors: a camera that cannot be, a target behind it, a stroke of no length or
/// one that runs along no part of the target.
[[nodiscard]] base::Result<DrawnTarget> drawn_over(const DrawnTarget& before,
                                                   std::span<const geometry::ModelPoint> reference, const View& view,
                                                   std::span<const curve::PxPoint> stroke);

/// True when two lines come within a distance of each other. A line of one point is that point.
[[nodiscard]] bool come_near(std::span<const curve::PxPoint> a, std::span<const curve::PxPoint> b, double distance_px);

}  // namespace penpose::document
