#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/animation/points/curve_transfer.h"
#include "core/geometry/camera.h"
#include "core/rig/rig.h"

namespace penpose::animation {

/// The uncertainty of parameters due to tremor of the tracked points when a pose is found from one frame. Controls that
/// undo or repeat each other on the curves, such as a frown and a smile, are each uncertain, but their sum is not. So
/// the uncertainty is also given along independent directions.
struct Uncertainty {
  std::vector<double> directions;  ///< unit vectors, one number a parameter, parameters as shares of their ranges; the
                                   ///< most certain first
  std::vector<double> deviations;  ///< standard deviation along each direction, above 0 to 0.25
  std::vector<double> parameters;  ///< the same for each parameter, as a share of its range, above 0 to 0.25
};

/// The information of one frame about the parameters `searched`, J^T W J / deviation^2 (n rows of n), with J the seen
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
