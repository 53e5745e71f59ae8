#include "core/io/picture_lines/trace/internal/strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace penpose::io {
namespace {

using geometry::PxPoint;

constexpr double k_straight = 0.64;         ///< cosine of the most that a line turns at a crossing, 50 degrees
constexpr std::size_t k_every_pairing = 4;  ///< up to so many ends all pairings are compared

/// An end of an edge at a node, and where it comes from.
struct Arm {
  std::size_t edge = 0;
  std::size_t side = 0;
  PxPoint direction;  ///< from the node, of length one
};

struct Partner {
  std::size_t edge = 0;
  std::size_t side = 0;
};

double straightness(const Arm& a, const Arm& b) { return -geometry::dot(a.direction, b.direction); }

class StrokeMaker {
 public:
  explicit StrokeMaker(const Skeleton& skeleton)
      : skeleton_(skeleton), partners_(skeleton.edges.size()), used_(skeleton.edges.size()) {}

  std::vector<TracedStroke> make() {
    std::vector<std::vector<Arm>> arms(skeleton_.nodes.size());
    for (std::size_t i = 0; i < skeleton_.edges.size(); ++i) {
      const SkeletonEdge& edge = skeleton_.edges[i];
      if (edge.is_loop()) continue;
      for (std::size_t side = 0; side < 2; ++side) {
        arms[edge.nodes[side]].push_back({i, side, leaving_direction(skeleton_, edge, side)});
      }
    }
    for (const auto& one : arms) pair(one);
    std::vector<TracedStroke> strokes;
    for (std::size_t i = 0; i < skeleton_.edges.size(); ++i) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (!used_[i] && !partners_[i][side]) strokes.push_back(walk({i, side}));
      }
    }
    // What is left goes round.
    for (std::size_t i = 0; i < skeleton_.edges.size(); ++i) {
      if (!used_[i]) strokes.push_back(walk({i, 0}));
    }
    return strokes;
  }

 private:
  void pair(std::vector<Arm> arms) {
    if (arms.size() == k_every_pairing) {
      // Two lines that cross at a small angle: what fits best as a whole.
      std::size_t best = 1;
      double most = -4;
      for (std::size_t with = 1; with < 4; ++with) {
        const std::size_t third = with == 1 ? 2 : 1;
        const std::size_t fourth = with == 3 ? 2 : 3;
        const double one = straightness(arms[0], arms[with]);
        const double other = straightness(arms[third], arms[fourth]);
        if (std::min(one, other) > k_straight && one + other > most) {
          most = one + other;
          best = with;
        }
      }
      if (most > -4) {
        join(arms[0], arms[best]);
        join(arms[best == 1 ? 2 : 1], arms[best == 3 ? 2 : 3]);
        return;
      }
    }
    while (arms.size() >= 2) {
      std::pair<std::size_t, std::size_t> best;
      double most = k_straight;
      for (std::size_t i = 0; i < arms.size(); ++i) {
        for (std::size_t k = i + 1; k < arms.size(); ++k) {
          const double straight = straightness(arms[i], arms[k]);
          if (straight > most) {
            most = straight;
            best = {i, k};
          }
        }
      }
      if (best.second == 0) return;
      join(arms[best.first], arms[best.second]);
      arms.erase(arms.begin() + static_cast<std::ptrdiff_t>(best.second));
      arms.erase(arms.begin() + static_cast<std::ptrdiff_t>(best.first));
    }
  }

  void join(const Arm& a, const Arm& b) {
    partners_[a.edge][a.side] = Partner{b.edge, b.side};
    partners_[b.edge][b.side] = Partner{a.edge, a.side};
  }

  /// Follows a stroke from an end of an edge through all that it is joined with.
  TracedStroke walk(Partner from) {
    TracedStroke stroke;
    double length = 0;
    const std::size_t first = from.edge;
    std::optional<Partner> next = from;
    while (next && !used_[next->edge]) {
      const SkeletonEdge& edge = skeleton_.edges[next->edge];
      used_[next->edge] = true;
      const double own = edge.length();
      stroke.radius += edge.radius * own;
      length += own;
      append(stroke.points, edge, next->side);
      next = partners_[next->edge][1 - next->side];
    }
    stroke.radius = length > 0 ? stroke.radius / length : skeleton_.edges[first].radius;
    stroke.closed = skeleton_.edges[first].is_loop() || next;
    if (next && stroke.points.size() > 1) stroke.points.push_back(stroke.points.front());
    return stroke;
  }

  /// Adds an edge's points from `side` on, without those in the ink that it shares at nodes where the stroke goes on:
  /// they are drawn towards the other lines there.
  void append(std::vector<PxPoint>& points, const SkeletonEdge& edge, std::size_t side) const {
    const std::size_t number = static_cast<std::size_t>(&edge - skeleton_.edges.data());
    const auto shared = [&](PxPoint p, std::size_t end) {
      if (edge.is_loop() || !partners_[number][end]) return false;
      const SkeletonNode& node = skeleton_.nodes[edge.nodes[end]];
      return geometry::distance(p, node.place) < node.reach;
    };
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      const PxPoint p = side == 0 ? edge.points[i] : edge.points[edge.points.size() - 1 - i];
      if (!shared(p, 0) && !shared(p, 1)) points.push_back(p);
    }
  }

  const Skeleton& skeleton_;
  std::vector<std::array<std::optional<Partner>, 2>> partners_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<TracedStroke> strokes_of(const Skeleton& skeleton) { return StrokeMaker(skeleton).make(); }

}  // namespace penpose::io
