#include "core/animation/solve/uncertainty.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/symmetric_eigen.h"
#include "core/animation/solve/seen_points.h"

namespace penpose::animation {
namespace {

using geometry::PxPoint;

constexpr double k_spread = 0.25;

/// Movement of every point in standard deviations of its tremor, weighted, for a parameter that goes through its range;
/// taken over a tenth of the range, towards the farther end of it.
std::vector<PxPoint> seen_movement(const rig::Parameter& range, std::size_t parameter, std::span<const double> rest,
                                   std::span<const PxPoint> at_rest, const Transfer& transfer, double deviation_px,
                                   SeenPoints& points) {
  constexpr double k_step = 0.1;
  const bool up = range.maximum - rest[parameter] >= rest[parameter] - range.minimum;
  const double step = up ? k_step : -k_step;
  rig::Pose pose(rest.begin(), rest.end());
  pose[parameter] += step * (range.maximum - range.minimum);
  std::vector<PxPoint> movement = points.at(pose);
  for (std::size_t i = 0; i < movement.size(); ++i) {
    const double deviation = deviation_px * transfer.scale[i];
    const double unit = deviation > 0 ? std::sqrt(transfer.weights[i]) / (step * deviation) : 0.0;
    movement[i] = (movement[i] - at_rest[i]) * unit;
  }
  return movement;
}

}  // namespace

std::vector<double> seen_information(const rig::Rig& rig, std::span<const double> rest,
                                     std::span<const std::size_t> searched, const Transfer& transfer,
                                     const geometry::Camera& camera, double deviation_px) {
  SeenPoints points(rig, transfer.points, camera);
  const std::vector<PxPoint> at_rest = points.at(rest);
  std::vector<std::vector<PxPoint>> movements;
  for (const std::size_t p : searched) {
    movements.push_back(seen_movement(rig.parameters()[p], p, rest, at_rest, transfer, deviation_px, points));
  }
  const std::size_t n = searched.size();
  std::vector<double> told(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      double sum = 0;
      for (std::size_t q = 0; q < at_rest.size(); ++q) {
        sum += movements[i][q].x * movements[k][q].x + movements[i][q].y * movements[k][q].y;
      }
      told[i * n + k] = told[k * n + i] = sum;
    }
  }
  return told;
}

Uncertainty parameter_uncertainty(const rig::Rig& rig, std::span<const double> rest,
                                  std::span<const std::size_t> searched, const Transfer& transfer,
                                  const geometry::Camera& camera, double deviation_px) {
  const std::size_t n = searched.size();
  algebra::SymmetricEigen eigen =
      algebra::symmetric_eigen(seen_information(rig, rest, searched, transfer, camera, deviation_px), n);
  Uncertainty result;
  for (const double value : eigen.values) {
    result.deviations.push_back(1.0 / std::sqrt(std::max(value, 0.0) + 1.0 / (k_spread * k_spread)));
  }
  for (std::size_t i = 0; i < n; ++i) {
    double squared = 0;
    for (std::size_t d = 0; d < n; ++d) {
      const double part = eigen.vectors[d * n + i] * result.deviations[d];
      squared += part * part;
    }
    result.parameters.push_back(std::sqrt(squared));
  }
  result.directions = std::move(eigen.vectors);
  return result;
}

}  // namespace penpose::animation
