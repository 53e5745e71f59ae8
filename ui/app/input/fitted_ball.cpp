#include "ui/app/input/fitted_ball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace penpose::app {
namespace {

constexpr std::size_t k_unknowns = 4;
/// A pivot below this, for points scaled to about one, means a plane.
constexpr double k_flat = 1e-9;
/// Of the distance to the nearest point.
constexpr double k_radius = 0.95;

using System = std::array<std::array<double, k_unknowns + 1>, k_unknowns>;

/// Gauss elimination with row pivots.
std::optional<std::array<double, k_unknowns>> solved(System rows) {
  for (std::size_t k = 0; k < k_unknowns; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < k_unknowns; ++i) {
      if (std::abs(rows[i][k]) > std::abs(rows[best][k])) best = i;
    }
    if (std::abs(rows[best][k]) < k_flat) return std::nullopt;
    std::swap(rows[k], rows[best]);
    for (std::size_t i = k + 1; i < k_unknowns; ++i) {
      const double by = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= k_unknowns; ++j) rows[i][j] -= by * rows[k][j];
    }
  }
  std::array<double, k_unknowns> x{};
  for (std::size_t k = k_unknowns; k-- > 0;) {
    x[k] = rows[k][k_unknowns];
    for (std::size_t j = k + 1; j < k_unknowns; ++j) x[k] -= rows[k][j] * x[j];
    x[k] /= rows[k][k];
  }
  return x;
}

}  // namespace

std::optional<articulation::Sphere> fitted_ball(std::span<const geometry::ModelPoint> points) {
  if (points.size() < k_unknowns) return std::nullopt;
  geometry::Box box;
  for (const auto& p : points) box.add(p);
  const double size = box.diagonal();
  if (!(size > 0)) return std::nullopt;
  const geometry::ModelPoint middle = box.center();
  System system{};
  for (const auto& point : points) {
    const geometry::ModelVector p = (point - middle) / size;
    const std::array<double, k_unknowns> row{p.x, p.y, p.z, 1};
    const double right = -(p.x * p.x + p.y * p.y + p.z * p.z);
    for (std::size_t i = 0; i < k_unknowns; ++i) {
      for (std::size_t j = 0; j < k_unknowns; ++j) system[i][j] += row[i] * row[j] / double(points.size());
      system[i][k_unknowns] += row[i] * right / double(points.size());
    }
  }
  const auto found = solved(system);
  if (!found) return std::nullopt;
  const geometry::ModelPoint center =
      middle + geometry::ModelVector{(*found)[0], (*found)[1], (*found)[2]} * (-0.5 * size);
  double nearest = std::numeric_limits<double>::max();
  for (const auto& point : points) nearest = std::min(nearest, geometry::distance(point, center));
  if (!(nearest > 0) || !std::isfinite(nearest)) return std::nullopt;
  return articulation::Sphere{center, k_radius * nearest};
}

}  // namespace penpose::app
