#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/animation/points/curve_transfer.h"
#include "core/geometry/camera.h"
#include "core/rig/rig.h"

namespace penpose::animation {

/// How far tremor of the tracked points leaves parameters in doubt when a pose is found from one frame. Controls that
/// undo or repeat one another on the curves, as a frown and a smile, are in doubt each, but what they do together is
/// not; so the doubt is told along directions of which each is in doubt on its own, too.
struct Uncertainty {
  std::vector<double> directions;  ///< one run of a number a parameter, of length one, parameters as shares of their
                                   ///< ranges; the most certain first
  std::vector<double> deviations;  ///< standard deviation along each direction, above 0 to 0.25
  std::vector<double> parameters;  ///< that of each parameter, as a share of its range, above 0 to 0.25
};

/// What the points tell of the parameters `searched` in one frame, J^T W J / deviation^2 (n rows of n), with J the seen
/// movement of the points from `rest`, parameters as shares of their ranges, and W their weights. `deviation_px`:
/// standard deviation of the tremor along each axis, px of the track, above 0.
[[nodiscard]] std::vector<double> seen_information(const rig::Rig& rig, std::span<const double> rest,
                                                   std::span<const std::size_t> searched, const Transfer& transfer,
                                                   const geometry::Camera& camera, double deviation_px);

/// The posterior of Bayesian linear regression (Bishop 2006, section 3.3), by the eigenvectors of its precision
/// seen_information + I / spread^2, with a usual movement `spread` of a quarter of each range. Arguments as there.
[[nodiscard]] Uncertainty parameter_uncertainty(const rig::Rig& rig, std::span<const double> rest,
                                                std::span<const std::size_t> searched, const Transfer& transfer,
                                                const geometry::Camera& camera, double deviation_px);

}  // namespace penpose::animation
