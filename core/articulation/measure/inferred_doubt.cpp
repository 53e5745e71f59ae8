#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/articulation/motion/reference_curve.h"

namespace penpose::articulation {
namespace {

/// Places along the curve at which is asked whether it has two sheets beside it; its ends may run out of one.
constexpr std::array<double, 9> k_places{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
/// At so many of them two sheets are more than chance.
constexpr std::size_t k_many = 4;
/// Farther than that from everything that it was found from, as a share of its extent, it runs beside the surface.
constexpr double k_doubt_beside = 0.2;
/// A core that reaches that far to either side of the curve (root mean square), as a share of the curve's length, tells
/// no direction.
constexpr double k_wide = 0.27;
/// Steps over edges that a walk on one sheet takes, and how near the other sheet must lie, in edges.
constexpr int k_steps = 7;
constexpr double k_near = 1.6;

double square_apart(const ModelPoint& a, const ModelPoint& b) {
  const ModelVector way = a - b;
  return glm::dot(way, way);
}

/// The vertices that a curve was found from, welded, and their neighbours among themselves.
class Core {
 public:
  Core(const Canvas& canvas, const Region& region, std::span<const std::uint32_t> specific) {
    constexpr std::uint32_t k_none = ~0U;
    const auto weld = canvas.mesh().weld();
    std::vector<std::uint32_t> number(canvas.positions().size(), k_none);
    for (const std::uint32_t i : specific) {
      const std::uint32_t v = weld[region.vertices[i]];
      if (number[v] != k_none) continue;
      number[v] = static_cast<std::uint32_t>(places.size());
      places.push_back(canvas.positions()[v]);
    }
    beside_.resize(places.size());
    double sum = 0;
    double count = 0;
    for (const mesh::Triangle& t : canvas.mesh().triangles()) {
      std::array<std::uint32_t, 3> at{};
      std::size_t known = 0;
      for (const std::uint32_t v : t) {
        const std::uint32_t found = number[weld[v]];
        if (found != k_none) at[known++] = found;
      }
      for (std::size_t i = 0; i < known; ++i) {
        for (std::size_t k = 0; k < known; ++k) {
          if (at[i] == at[k]) continue;
          beside_[at[i]].push_back(at[k]);
          sum += geometry::distance(places[at[i]], places[at[k]]);
          count += 1;
        }
      }
    }
    edge = count > 0 ? sum / count : 0.0;
  }

  std::vector<ModelPoint> places;
  double edge = 0;  ///< mean length

  [[nodiscard]] std::size_t nearest(const ModelPoint& to) const {
    std::size_t best = 0;
    double nearest = square_apart(places[0], to);
    for (std::size_t i = 1; i < places.size(); ++i) {
      const double square = square_apart(places[i], to);
      // What differs in the squares' last bits alone is as near.
      if (!(square < nearest) || !(std::sqrt(square) < std::sqrt(nearest))) continue;
      best = i;
      nearest = square;
    }
    return best;
  }

  /// Whether something lies right beside a vertex that no short walk over the surface leads to.
  [[nodiscard]] bool has_other_sheet(std::size_t at) const {
    std::vector<std::uint8_t> reached(places.size(), 0);
    std::vector<std::uint32_t> front{static_cast<std::uint32_t>(at)};
    reached[at] = 1;
    for (int step = 0; step < k_steps; ++step) {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t node : front) {
        for (const std::uint32_t other : beside_[node]) {
          if (reached[other] != 0) continue;
          reached[other] = 1;
          next.push_back(other);
        }
      }
      front = std::move(next);
    }
    const double near = k_near * edge;
    const double surely_far = 1.000001 * near * near;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (reached[i] != 0) continue;
      const double square = square_apart(places[i], places[at]);
      if (square < surely_far && std::sqrt(square) < near) return true;
    }
    return false;
  }

 private:
  std::vector<std::vector<std::uint32_t>> beside_;
};

double distance_to(std::span<const ModelPoint> curve, const ModelPoint& p) {
  double nearest = square_apart(curve.front(), p);
  for (const ModelPoint& q : curve) nearest = std::min(nearest, square_apart(q, p));
  return std::sqrt(nearest);
}

}  // namespace

std::string doubt_of_inferred(const Canvas& canvas, const Region& region, std::span<const std::uint32_t> specific,
                              std::span<const ModelPoint> inferred) {
  const Core core(canvas, region, specific);
  // Not its length: what is left of a zigzag would make a blob long.
  geometry::Box box;
  for (const ModelPoint& point : inferred) box.add(point);
  const double length = box.diagonal();
  if (core.places.size() < 3 || !(core.edge > 0.0) || !(length > 0.0)) return {};
  std::size_t between = 0;
  for (const double place : k_places) {
    const auto at = static_cast<std::size_t>(place * static_cast<double>(inferred.size() - 1) + 0.5);
    between += core.has_other_sheet(core.nearest(inferred[at])) ? 1 : 0;
  }
  if (between >= k_many)
    return "two sheets of the surface lie beside each other there, as lips do, and it runs between";
  double beside = 0;
  for (const ModelPoint& p : inferred) {
    beside = std::max(beside, geometry::distance(core.places[core.nearest(p)], p) - core.edge);
  }
  if (beside > k_doubt_beside * length) return "it leaves the surface";
  double square = 0;
  for (const ModelPoint& p : core.places) {
    const double off = distance_to(inferred, p);
    square += off * off;
  }
  if (std::sqrt(square / static_cast<double>(core.places.size())) > k_wide * length) {
    return "what moves fully is about as wide as it is long, so that which way it runs is a guess";
  }
  return {};
}

}  // namespace penpose::articulation
