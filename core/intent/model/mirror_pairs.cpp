#include "core/intent/model/mirror_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::intent {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

constexpr std::size_t k_none = static_cast<std::size_t>(-1);

struct Plane {
  ModelVector normal{1, 0, 0};
  double offset = 0;
  [[nodiscard]] ModelVector turned(const ModelVector& v) const { return v - normal * (2.0 * glm::dot(normal, v)); }
  [[nodiscard]] ModelPoint mirrored(const ModelPoint& p) const {
    return p - normal * (2.0 * (glm::dot(normal, p) - offset));
  }
};

/// How far b is from being a's mirror image; 1 is the limit of what passes.
double difference(const ControlMoments& a, const ControlMoments& b, const Plane& plane, double tolerance, double size) {
  if (!(a.way > 0.0 && b.way > 0.0)) return 2.0;
  const double apart = std::abs(glm::dot(plane.normal, a.centre - b.centre));
  if (apart < 0.35 * (a.radius + b.radius)) return 2.0;  // both in the middle
  const double place = geometry::distance(plane.mirrored(a.centre), b.centre) / (tolerance * size);
  const double amount = std::abs(a.way - b.way) / (0.3 * std::max(a.way, b.way));
  const double way = geometry::length(plane.turned(a.direction) - b.direction) / 0.35;
  const double radius = std::abs(a.radius - b.radius) / (0.35 * std::max(a.radius, b.radius));
  return std::max(std::max(place, amount), std::max(way, radius)) < 1.0 ? (place + amount + way + radius) / 4.0 : 2.0;
}

std::vector<std::size_t> pairs_about(std::span<const ControlMoments> controls, const Plane& plane, double tolerance,
                                     double size) {
  const std::size_t d = controls.size();
  std::vector<std::size_t> best(d, k_none);
  for (std::size_t i = 0; i < d; ++i) {
    double least = 1.0;
    for (std::size_t j = 0; j < d; ++j) {
      if (j == i) continue;
      const double far = difference(controls[i], controls[j], plane, tolerance, size);
      if (far < least) {
        least = far;
        best[i] = j;
      }
    }
  }
  std::vector<std::size_t> mutual(d, k_none);
  for (std::size_t i = 0; i < d; ++i) {
    if (best[i] != k_none && best[best[i]] == i) mutual[i] = best[i];
  }
  return mutual;
}

/// The plane between the two sides of the pairs.
Plane plane_between(std::span<const ControlMoments> controls, std::span<const std::size_t> partner, Plane plane) {
  ModelVector across{0};
  double offset = 0;
  double count = 0;
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (partner[i] == k_none || partner[i] < i) continue;
    const ModelVector d = controls[i].centre - controls[partner[i]].centre;
    across += glm::dot(d, plane.normal) < 0.0 ? -d : d;
    count += 1.0;
  }
  plane.normal = geometry::normalized(across, plane.normal);
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (partner[i] == k_none || partner[i] < i) continue;
    offset += glm::dot(plane.normal, (controls[i].centre + controls[partner[i]].centre) * 0.5);
  }
  if (count > 0.0) plane.offset = offset / count;
  return plane;
}

}  // namespace

ControlMoments moments_of(std::span<const ModelPoint> rest, std::span<const ModelPoint> moved) {
  ControlMoments m;
  ModelVector direction{0};
  double squares = 0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const ModelVector d = moved[v] - rest[v];
    const double way = geometry::length(d);
    if (!(way > 0.0) || !std::isfinite(way)) continue;
    m.way += way;
    squares += way * way;
    m.centre += rest[v] * way;
    direction += d * way;
  }
  if (!(m.way > 0.0)) return m;
  m.centre /= m.way;
  m.direction = direction / squares;
  double spread = 0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const double way = geometry::length(moved[v] - rest[v]);
    if (!(way > 0.0) || !std::isfinite(way)) continue;
    const ModelVector d = rest[v] - m.centre;
    spread += way * glm::dot(d, d);
  }
  m.radius = std::sqrt(spread / m.way);
  return m;
}

std::vector<std::size_t> mirror_pairs(std::span<const ControlMoments> controls, const ModelPoint& middle, double size) {
  std::vector<std::size_t> most(controls.size(), k_none);
  std::ptrdiff_t most_count = 0;
  if (!(size > 0.0)) return most;
  for (const ModelVector& axis : {ModelVector{1, 0, 0}, ModelVector{0, 0, 1}, ModelVector{0, 1, 0}}) {
    Plane plane{axis, glm::dot(axis, middle)};
    std::vector<std::size_t> partner;
    for (const double tolerance : {0.12, 0.06, 0.04}) {
      partner = pairs_about(controls, plane, tolerance, size);
      plane = plane_between(controls, partner, plane);
    }
    const auto count = std::count_if(partner.begin(), partner.end(), [](std::size_t p) { return p != k_none; });
    if (count <= most_count) continue;
    most_count = count;
    most = std::move(partner);
  }
  return most;
}

}  // namespace penpose::intent
