#include "core/intent/model/mirror_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/intent/model/control_fields.h"
#include "core/intent/model/place_grid.h"

namespace penpose::intent {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

constexpr std::size_t k_none = static_cast<std::size_t>(-1);
/// By how much the sums of two controls differ at most, as a share of the larger one, and their directions.
constexpr double k_most_amount = 0.3, k_most_way = 0.35;
/// More than a limit by this is beyond it, however it is rounded.
constexpr double k_surely = 1.001;

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
  const double amount = std::abs(a.way - b.way) / (k_most_amount * std::max(a.way, b.way));
  const double way = geometry::length(plane.turned(a.direction) - b.direction) / k_most_way;
  const double radius = std::abs(a.radius - b.radius) / (0.35 * std::max(a.radius, b.radius));
  return std::max(std::max(place, amount), std::max(way, radius)) < 1.0 ? (place + amount + way + radius) / 4.0 : 2.0;
}

/// Controls that move anything, by how much.
std::vector<std::size_t> by_way(std::span<const ControlMoments> controls) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    if (controls[i].way > 0.0) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return controls[a].way < controls[b].way; });
  return order;
}

std::vector<std::size_t> pairs_about(std::span<const ControlMoments> controls, const Plane& plane, double tolerance,
                                     double size) {
  const std::size_t d = controls.size();
  std::vector<std::size_t> best(d, k_none);
  // Of many controls only few can be a pair: those near each other's mirror images that move as much.
  const std::vector<std::size_t> order = by_way(controls);
  std::vector<ModelPoint> centres;
  for (const std::size_t i : order) centres.push_back(controls[i].centre);
  const PlaceGrid grid(centres, tolerance * size);
  const auto first_with = [&](double way) {
    const auto at =
        std::lower_bound(order.begin(), order.end(), way, [&](std::size_t i, double w) { return controls[i].way < w; });
    return static_cast<std::uint32_t>(at - order.begin());
  };
  for (const std::size_t i : order) {
    const ControlMoments& own = controls[i];
    const ModelPoint image = plane.mirrored(own.centre);
    const ModelVector direction = plane.turned(own.direction);
    double least = 1.0;
    const auto compare = [&](std::uint32_t number) {
      const std::size_t j = order[number];
      if (j == i) return;
      // The difference is the mean of four: what is four times as far in one alone is no better.
      const double most = k_surely * std::min(1.0, 4.0 * least);
      const double most_place = most * tolerance * size;
      const double most_way = most * k_most_way;
      if (square_of(image - controls[j].centre) > most_place * most_place) return;
      if (square_of(direction - controls[j].direction) > most_way * most_way) return;
      const double far = difference(own, controls[j], plane, tolerance, size);
      // Of equals the first, whatever the order of the grid.
      if (far < least || (far == least && j < best[i] && best[i] != k_none)) {
        least = far;
        best[i] = j;
      }
    };
    constexpr double k_least_share = 1.0 - k_surely * k_most_amount;
    grid.visit_near(image, first_with(own.way * k_least_share), first_with(own.way / k_least_share), compare);
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
