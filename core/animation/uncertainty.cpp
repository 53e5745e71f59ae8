#include "core/animation/uncertainty.h"

#include <cmath>

#include "core/animation/seen_points.h"

namespace penpose::animation {
namespace {

using geometry::PxPoint;

constexpr double k_spread = 0.25;

/// Movement of every point in standard deviations of its tremor, weighted, for a parameter that goes through its range;
/// taken over the first tenth of the way to the farther end of it.
std::vector<PxPoint> seen_movement(const rig::Parameter& range, std::size_t parameter, std::span<const double> rest,
                                   const Transfer& transfer, double deviation_px, SeenPoints& points) {
  constexpr double k_step = 0.1;
  const bool up = range.maximum - rest[parameter] >= rest[parameter] - range.minimum;
  const double step = up ? k_step : -k_step;
  rig::Pose pose(rest.begin(), rest.end());
  const std::vector<PxPoint> from = points.at(pose);
  pose[parameter] += step * (range.maximum - range.minimum);
  std::vector<PxPoint> movement = points.at(pose);
  for (std::size_t i = 0; i < movement.size(); ++i) {
    const double deviation = deviation_px * transfer.scale[i];
    const double unit = deviation > 0 ? std::sqrt(transfer.weights[i]) / (step * deviation) : 0.0;
    movement[i] = (movement[i] - from[i]) * unit;
  }
  return movement;
}

/// Square roots of the diagonal of the inverse of a positive definite matrix, by its Cholesky factor.
std::vector<double> roots_of_inverse_diagonal(std::vector<double> a, std::size_t n) {
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = j; i < n; ++i) {
      double sum = a[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i * n + k] * a[j * n + k];
      a[i * n + j] = i == j ? std::sqrt(sum) : sum / a[j * n + j];
    }
  }
  std::vector<double> roots;
  std::vector<double> column(n);
  for (std::size_t p = 0; p < n; ++p) {
    double squared = 0;
    for (std::size_t i = p; i < n; ++i) {
      double sum = i == p ? 1.0 : 0.0;
      for (std::size_t k = p; k < i; ++k) sum -= a[i * n + k] * column[k];
      column[i] = sum / a[i * n + i];
      squared += column[i] * column[i];
    }
    roots.push_back(std::sqrt(squared));
  }
  return roots;
}

}  // namespace

std::vector<double> parameter_uncertainty(const rig::Rig& rig, std::span<const double> rest,
                                          std::span<const std::size_t> searched, const Transfer& transfer,
                                          const geometry::Camera& camera, double deviation_px) {
  SeenPoints points(rig, transfer.points, camera);
  std::vector<std::vector<PxPoint>> movements;
  for (const std::size_t p : searched) {
    movements.push_back(seen_movement(rig.parameters()[p], p, rest, transfer, deviation_px, points));
  }
  const std::size_t n = searched.size();
  std::vector<double> precision(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      double sum = i == k ? 1.0 / (k_spread * k_spread) : 0.0;
      for (std::size_t q = 0; q < movements[i].size(); ++q) {
        sum += movements[i][q].x * movements[k][q].x + movements[i][q].y * movements[k][q].y;
      }
      precision[i * n + k] = sum;
    }
  }
  return roots_of_inverse_diagonal(std::move(precision), n);
}

}  // namespace penpose::animation
