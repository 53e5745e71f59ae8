#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/animation/curve_transfer.h"
#include "core/geometry/camera.h"
#include "core/rig/rig.h"

namespace penpose::animation {

/// How far tremor of the tracked points leaves each of the parameters `searched` in doubt when a pose is found from one
/// frame: the standard deviation, as a share of the parameter's range. Parameters that move the curves little, and
/// those that undo one another there, as a frown and a smile, are in more doubt than a jaw. It is the posterior of
/// Bayesian linear regression (Bishop 2006, section 3.3), covariance (J^T W J / deviation^2 + I / spread^2)^-1 with J
/// the seen movement of the points from `rest`, W their weights and a usual movement `spread` of a quarter of the
/// range.
///
/// `deviation_px`: standard deviation of the tremor along each axis, px of the track, above 0. Returns one number a
/// parameter in `searched`, above 0 to 0.25.
[[nodiscard]] std::vector<double> parameter_uncertainty(const rig::Rig& rig, std::span<const double> rest,
                                                        std::span<const std::size_t> searched, const Transfer& transfer,
                                                        const geometry::Camera& camera, double deviation_px);

}  // namespace penpose::animation
