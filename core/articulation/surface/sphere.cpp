#include "core/articulation/surface/sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/algebra/elimination.h"

namespace penpose::articulation {
namespace {

constexpr std::size_t k_unknowns = 4;
/// A pivot below this, for points scaled to about one, means a plane.
constexpr double k_flat_sphere = 1e-9;
/// Of the distance to the nearest point.
constexpr double k_radius = 0.95;

class HeldSphere : public HeldSurface {
 public:
  explicit HeldSphere(const Sphere& ball) : ball_(ball) {}

  /// On or inside the ball, within a thousandth of its radius.
  [[nodiscard]] bool consists_of(std::uint32_t /*vertex*/, const ModelPoint& rest) const override {
    return level(rest) <= ball_.radius * 1.001;
  }
  [[nodiscard]] double level(const ModelPoint& rest) const override { return geometry::distance(rest, ball_.center); }
  /// Along the ray from the centre.
  [[nodiscard]] ModelPoint keep(const ModelPoint& moved, const ModelPoint& rest, double level) const override {
    ModelVector ray = moved - ball_.center;
    double size = geometry::length(ray);
    if (!(size > 1e-12 * level)) {
      ray = rest - ball_.center;
      size = level;
    }
    return size > 0.0 ? ball_.center + ray * (level / size) : rest;
  }
  [[nodiscard]] double lift(const geometry::Ray& ray, double near, double level) const override {
    const ModelVector from = ray.origin - ball_.center;
    const double b = glm::dot(from, ray.direction);
    const double square = b * b - (glm::dot(from, from) - level * level);
    const double half = square > 0.0 ? std::sqrt(square) : 0.0;
    const double first = -b - half;
    const double second = -b + half;
    const double lifted = std::abs(first - near) <= std::abs(second - near) ? first : second;
    return lifted > 0.0 ? lifted : near;
  }
  [[nodiscard]] std::optional<ModelPoint> center() const override { return ball_.center; }

 private:
  Sphere ball_;
};

}  // namespace

std::optional<Sphere> Sphere::fitted(std::span<const ModelPoint> points) {
  if (points.size() < k_unknowns) return std::nullopt;
  geometry::Box box;
  for (const auto& p : points) box.add(p);
  const double size = box.diagonal();
  if (!(size > 0)) return std::nullopt;
  const ModelPoint middle = box.center();
  algebra::Equations<k_unknowns> system{};
  for (const auto& point : points) {
    const ModelVector p = (point - middle) / size;
    const std::array<double, k_unknowns> row{p.x, p.y, p.z, 1};
    const double right = -(p.x * p.x + p.y * p.y + p.z * p.z);
    for (std::size_t i = 0; i < k_unknowns; ++i) {
      for (std::size_t j = 0; j < k_unknowns; ++j) system[i][j] += row[i] * row[j] / double(points.size());
      system[i][k_unknowns] += row[i] * right / double(points.size());
    }
  }
  const auto found = algebra::solve<k_unknowns>(system, k_flat_sphere);
  if (!found) return std::nullopt;
  const ModelPoint at = middle + ModelVector{(*found)[0], (*found)[1], (*found)[2]} * (-0.5 * size);
  double nearest = std::numeric_limits<double>::max();
  for (const auto& point : points) nearest = std::min(nearest, geometry::distance(point, at));
  if (!(nearest > 0) || !std::isfinite(nearest)) return std::nullopt;
  return Sphere{at, k_radius * nearest};
}

base::Status Sphere::check() const {
  if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(center.z)) {
    return base::Error{"the centre of the ball is not finite", "surface/sphere/center", "give three plain numbers"};
  }
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    return base::Error{"the ball has no radius", "surface/sphere/radius", "give a radius above 0"};
  }
  return base::Done{};
}

base::Result<std::shared_ptr<const HeldSurface>> Sphere::held(const Canvas& /*canvas*/) const {
  return std::shared_ptr<const HeldSurface>(std::make_shared<const HeldSphere>(*this));
}

std::vector<OfferedSurface<Sphere>> Sphere::offered(const mesh::TriangleMesh& /*mesh*/, const RegionPoints& region) {
  return {{words(), "A ball that fits the region, once it is drawn", [region] { return fitted(region()); },
           "a ball is fitted to the region: draw the region first, then choose the ball"}};
}

}  // namespace penpose::articulation
