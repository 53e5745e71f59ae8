#include "core/articulation/region/falloff.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/articulation/region/geodesic.h"

namespace penpose::articulation {
namespace {

constexpr double k_far = std::numeric_limits<double>::infinity();
/// The share of the falloff at either end over which its slope grows: no crease where it begins, and at most 1/(1 - k)
/// times as steep as a straight one.
constexpr double k_ease = 0.15;
constexpr int k_smoothings = 3;
/// A piece that the second lasso cuts off belongs to the core but where it is smaller than this share of the largest
/// one and its way there leads around as far as that on average: the rim of the other lip, not the back of this one.
constexpr double k_smaller = 0.35;
constexpr double k_around = 4;

/// 0..1 -> 0..1 with slope 0 at both ends, straight between them.
double eased(double x) {
  constexpr double k_rise = 1.0 / (1.0 - k_ease);
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  if (x < k_ease) return 0.5 * k_rise * x * x / k_ease;
  if (x > 1.0 - k_ease) return 1.0 - 0.5 * k_rise * (1.0 - x) * (1.0 - x) / k_ease;
  return k_rise * (x - 0.5 * k_ease);
}

/// Where nodes of `from` (1 a node) have a neighbour that is not of it: what lies on the way out, as seeds at the nodes
/// outside. `border` tells how far a node lies from the drawn border, in px.
template <typename Border>
std::vector<GeodesicSeed> seeds_outside(const Patch& patch, std::span<const std::uint8_t> from, const Border& border) {
  std::vector<double> best(patch.node_count(), k_far);
  std::vector<double> px(patch.node_count(), -1.0);
  const auto px_of = [&](std::uint32_t node) {
    if (px[node] < 0.0) px[node] = border(node);
    return px[node];
  };
  for (const mesh::Triangle& t : patch.triangles()) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (const auto& [a, b] : {std::pair{t[i], t[(i + 1) % 3]}, std::pair{t[(i + 1) % 3], t[i]}}) {
        if (from[a] == 0 || from[b] != 0) continue;
        const double beyond = px_of(b);
        const double before = px_of(a);
        const double share = beyond + before > 0.0 ? beyond / (beyond + before) : 0.5;
        best[b] = std::min(best[b], share * geometry::distance(patch.rests()[a], patch.rests()[b]));
      }
    }
  }
  std::vector<GeodesicSeed> seeds;
  for (std::uint32_t node = 0; node < best.size(); ++node) {
    if (best[node] < k_far) seeds.push_back({node, best[node]});
  }
  return seeds;
}

/// Some nodes of a patch, to find the nearest of.
class Nearest {
 public:
  Nearest(const Patch& patch, std::span<const std::uint8_t> some) {
    geometry::Box box;
    for (std::uint32_t node = 0; node < some.size(); ++node) {
      if (some[node] != 0) box.add(patch.rests()[node]);
      if (some[node] != 0) points_.push_back(patch.rests()[node]);
    }
    const ModelVector size = box.maximum - box.minimum;
    axis_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::stable_sort(points_.begin(), points_.end(),
                     [this](const ModelPoint& a, const ModelPoint& b) { return a[axis_] < b[axis_]; });
  }

  /// The distance to the nearest; `most` where none is nearer than that.
  [[nodiscard]] double distance(const ModelPoint& from, double most) const {
    const auto middle = std::lower_bound(points_.begin(), points_.end(), from[axis_],
                                         [this](const ModelPoint& p, double x) { return p[axis_] < x; });
    double least = most * most;
    const auto nearer = [&](const ModelPoint& p) {
      const ModelVector way = p - from;
      if (way[axis_] * way[axis_] >= least) return false;
      least = std::min(least, glm::dot(way, way));
      return true;
    };
    for (auto p = middle; p != points_.end() && nearer(*p); ++p) {
    }
    for (auto p = middle; p != points_.begin() && nearer(*(p - 1)); --p) {
    }
    return std::sqrt(least);
  }

 private:
  std::vector<ModelPoint> points_;
  int axis_ = 0;
};

/// A connected piece of the core.
struct CorePiece {
  double area = 0;
  std::vector<std::uint32_t> nodes;
};

std::vector<CorePiece> pieces_of(const Patch& patch, std::span<const std::uint8_t> core) {
  std::vector<std::uint8_t> taken(patch.node_count(), 0);
  std::vector<CorePiece> pieces;
  for (std::uint32_t start = 0; start < patch.inner_count(); ++start) {
    if (core[start] == 0 || taken[start] != 0) continue;
    CorePiece& piece = pieces.emplace_back();
    piece.nodes.push_back(start);
    taken[start] = 1;
    for (std::size_t i = 0; i < piece.nodes.size(); ++i) {
      for (const std::uint32_t t : patch.star(piece.nodes[i])) {
        const auto& [a, b, c] = patch.triangles()[t];
        const ModelPoint& from = patch.rests()[a];
        piece.area += geometry::length(glm::cross(patch.rests()[b] - from, patch.rests()[c] - from));
        for (const std::uint32_t other : {a, b, c}) {
          if (core[other] == 0 || taken[other] != 0) continue;
          taken[other] = 1;
          piece.nodes.push_back(other);
        }
      }
    }
  }
  return pieces;
}

}  // namespace

/// Takes the rims of other lips out of the core.
void Falloff::drop_rims() {
  const std::vector<CorePiece> pieces = pieces_of(patch_, specific_);
  if (pieces.size() < 2) return;
  const CorePiece& largest = *std::max_element(pieces.begin(), pieces.end(),
                                               [](const CorePiece& a, const CorePiece& b) { return a.area < b.area; });
  std::vector<std::uint8_t> main(patch_.node_count(), 0);
  for (const std::uint32_t node : largest.nodes) main[node] = 1;
  std::vector<std::uint8_t> open(patch_.node_count(), 0);
  for (std::uint32_t node = 0; node < patch_.inner_count(); ++node) open[node] = main[node] == 0 ? 1 : 0;
  const auto around = geodesic_distances(patch_, seeds_outside(patch_, main, [](std::uint32_t) { return 1.0; }), open);
  const Nearest nearest(patch_, main);
  for (const CorePiece& piece : pieces) {
    if (!(piece.area < k_smaller * largest.area)) continue;
    double way = 0;
    double straight = 0;
    for (const std::uint32_t node : piece.nodes) {
      way += around[node];
      straight += around[node] < k_far ? nearest.distance(patch_.rests()[node], 2.0 * around[node]) : 0.0;
    }
    if (!(way > k_around * straight)) continue;
    for (const std::uint32_t node : piece.nodes) specific_[node] = 0;
  }
}

Falloff::Falloff(const Patch& patch, const DrawnRegions& drawn)
    : patch_(patch), inner_(patch.node_count(), 0), specific_(patch.node_count(), 0) {
  std::vector<geometry::PxPoint> seen(patch.node_count(), {-1e6, -1e6});
  std::vector<std::uint8_t> outer(patch.node_count(), 1);
  for (std::uint32_t node = 0; node < patch.node_count(); ++node) {
    if (const auto px = drawn.camera.project(patch.rests()[node])) seen[node] = *px;
    if (node >= patch.inner_count()) continue;
    inner_[node] = 1;
    outer[node] = 0;
    specific_[node] = drawn.specific.contains(seen[node]) ? 1 : 0;
  }
  find_beyond(drawn, seen);
  drop_rims();
  to_border_ = geodesic_distances(
      patch, seeds_outside(patch, outer, [&](std::uint32_t node) { return drawn.general.distance(seen[node]); }),
      inner_);
  std::vector<std::uint8_t> between(patch.node_count(), 0);
  for (std::uint32_t node = 0; node < patch.inner_count(); ++node) between[node] = specific_[node] == 0 ? 1 : 0;
  to_specific_ = geodesic_distances(
      patch, seeds_outside(patch, specific_, [&](std::uint32_t node) { return drawn.specific.distance(seen[node]); }),
      between);
  // All of the model was drawn around: it has no border, and what is farthest from the core stands for one.
  const bool bordered = std::any_of(to_border_.begin(), to_border_.end(), [](double d) { return d < k_far; });
  if (bordered) return;
  double farthest = 0;
  for (const double d : to_specific_) farthest = d < k_far ? std::max(farthest, d) : farthest;
  for (std::size_t node = 0; node < to_border_.size(); ++node) {
    if (specific_[node] == 0 && to_specific_[node] < k_far) to_border_[node] = farthest - to_specific_[node];
  }
}

void Falloff::find_beyond(const DrawnRegions& drawn, std::span<const geometry::PxPoint> seen) {
  geometry::PxPoint inside;
  geometry::PxPoint beyond;
  double inside_count = 0;
  double beyond_count = 0;
  for (std::uint32_t node = 0; node < patch_.node_count(); ++node) {
    const bool inner = node < patch_.inner_count();
    if (inner ? specific_[node] == 0 : !drawn.specific.contains(seen[node])) continue;
    // Of another piece of the model than the region.
    if (!inner && drawn.general.contains(seen[node])) continue;
    (inner ? inside : beyond) = (inner ? inside : beyond) + seen[node];
    (inner ? inside_count : beyond_count) += 1;
  }
  if (beyond_count == 0.0 || inside_count == 0.0) return;
  const geometry::PxPoint way = beyond * (1.0 / beyond_count) - inside * (1.0 / inside_count);
  if (std::abs(way.x) > std::abs(way.y)) {
    reaches_beyond_ = way.x > 0.0 ? "on its right" : "on its left";
  } else {
    reaches_beyond_ = way.y > 0.0 ? "at its lower side" : "at its upper side";
  }
}

std::vector<double> Falloff::weights() const { return blended(to_specific_, specific_); }

std::vector<double> Falloff::inward() const {
  std::vector<std::uint8_t> beside(patch_.node_count(), 0);
  for (std::size_t node = 0; node < beside.size(); ++node) beside[node] = specific_[node] == 0 ? 1 : 0;
  return geodesic_distances(patch_, seeds_outside(patch_, beside, [](std::uint32_t) { return 1.0; }), specific_);
}

std::vector<double> Falloff::weights(double depth, std::span<const double> inward,
                                     std::span<const double> to_curve) const {
  std::vector<std::uint8_t> core(patch_.node_count(), 0);
  std::vector<std::uint8_t> open(patch_.node_count(), 0);
  bool any = false;
  for (std::uint32_t node = 0; node < patch_.inner_count(); ++node) {
    const double in = inward[node];
    const bool deep = specific_[node] != 0 && !(in < depth * (in + to_curve[node]));
    core[node] = deep ? 1 : 0;
    open[node] = deep ? 0 : 1;
    any = any || deep;
  }
  if (!any) return weights();
  return blended(geodesic_distances(patch_, seeds_outside(patch_, core, [](std::uint32_t) { return 1.0; }), open),
                 core);
}

std::vector<double> Falloff::blended(std::span<const double> to_core, std::span<const std::uint8_t> core) const {
  std::vector<double> weights(patch_.node_count(), 0.0);
  for (std::uint32_t node = 0; node < patch_.inner_count(); ++node) {
    if (core[node] != 0) {
      weights[node] = 1.0;
    } else if (!(to_border_[node] < k_far)) {
      weights[node] = to_core[node] < k_far ? 1.0 : 0.0;
    } else if (to_core[node] < k_far) {
      const double sum = to_border_[node] + to_core[node];
      weights[node] = eased(sum > 0.0 ? to_border_[node] / sum : 0.0);
    }
  }
  struct Neighbour {
    std::uint32_t node;
    double says;
  };
  struct Fan {
    std::uint32_t node;
    std::size_t end;  ///< of its neighbours
    double count;
  };
  std::vector<Neighbour> neighbours;
  std::vector<Fan> fans;
  for (std::uint32_t node = 0; node < patch_.inner_count(); ++node) {
    if (core[node] != 0) continue;
    double count = 0;
    for (const std::uint32_t t : patch_.star(node)) {
      for (const std::uint32_t other : patch_.triangles()[t]) {
        if (other == node) continue;
        // The shorter the edge the more it says, so that the corners of a sliver do not part.
        const ModelVector edge = patch_.rests()[other] - patch_.rests()[node];
        const double says = 1.0 / std::max(std::sqrt(glm::dot(edge, edge)), 1e-150);
        neighbours.push_back({other, says});
        count += says;
      }
    }
    fans.push_back({node, neighbours.size(), count});
  }
  std::vector<double> next = weights;
  for (int pass = 0; pass < k_smoothings; ++pass) {
    std::size_t at = 0;
    for (const Fan& fan : fans) {
      double sum = 0;
      for (; at < fan.end; ++at) sum += weights[neighbours[at].node] * neighbours[at].says;
      next[fan.node] = fan.count > 0.0 ? 0.5 * weights[fan.node] + 0.5 * sum / fan.count : weights[fan.node];
    }
    std::swap(weights, next);
  }
  return weights;
}

}  // namespace penpose::articulation
