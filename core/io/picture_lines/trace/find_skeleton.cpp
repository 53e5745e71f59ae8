#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/io/picture_lines/trace/internal/skeleton.h"
#include "core/io/picture_lines/trace/internal/thinning.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_radius_every = 4;       ///< px along a line
constexpr std::ptrdiff_t k_widest_radius = 64;  ///< px; what is wider counts as this
constexpr double k_look_px = 12;                ///< how far along a line its direction is taken, at the least
constexpr int k_largest_grain = 6;              ///< px of a hole in a line

/// Half of the width of the ink around a px of its middle: how far the nearest paper is.
double radius_at(const Bitmap& ink, std::size_t at) {
  const auto down = static_cast<std::ptrdiff_t>(ink.stride());
  std::ptrdiff_t best = k_widest_radius * k_widest_radius;
  const auto look = [&](std::ptrdiff_t dx, std::ptrdiff_t dy) {
    const std::ptrdiff_t square = dx * dx + dy * dy;
    if (square < best && ink[at + static_cast<std::size_t>(dx + dy * down)] == 0) best = square;
  };
  // The margin is paper, so that none looks beyond it.
  for (std::ptrdiff_t r = 1; r * r < best; ++r) {
    look(0, -r);
    look(0, r);
    look(-r, 0);
    look(r, 0);
    for (std::ptrdiff_t k = 1; k <= r && r * r + k * k < best; ++k) {
      for (const std::ptrdiff_t side : {-k, k}) {
        look(side, -r);
        look(side, r);
        look(-r, side);
        look(r, side);
      }
    }
  }
  return std::sqrt(static_cast<double>(best)) - 0.5;
}

/// Follows the px of a thinned picture from node to node.
class SkeletonFinder {
 public:
  explicit SkeletonFinder(Bitmap ink) : ink_(std::move(ink)), thin_(ink_) {}

  Skeleton find() {
    close_holes(ink_, k_largest_grain);
    thin_ = ink_;
    const auto all = thin(thin_);
    for (const std::uint32_t at : all) thin_[at] = k_line;
    for (const std::uint32_t at : all) {
      if (neighbours(at) != 2) thin_[at] = k_node;
    }
    node_of_.assign(thin_.size(), 0);
    for (const std::uint32_t at : all) {
      if (thin_[at] == k_node && node_of_[at] == 0) make_node(at);
    }
    for (const std::uint32_t at : all) {
      if (thin_[at] == k_node) follow_from(at);
    }
    for (const std::uint32_t at : all) {
      if (thin_[at] == k_line) follow_loop(at);
    }
    return std::move(skeleton_);
  }

 private:
  static constexpr std::uint8_t k_line = 1;
  static constexpr std::uint8_t k_node = 2;
  static constexpr std::uint8_t k_done = 3;

  /// Finds the px beside one: those that share a side, and those at a corner between which and it there is no other way
  /// (mixed adjacency; Gonzalez and Woods, Digital Image Processing, 4th edition, section 2.5). Returns how many.
  std::size_t neighbours(std::size_t at) {
    const std::size_t down = thin_.stride();
    const std::array<std::size_t, 4> sides{at - down, at + 1, at + down, at - 1};
    const std::array<std::size_t, 4> corners{at - down + 1, at + down + 1, at + down - 1, at - down - 1};
    std::size_t count = 0;
    for (const std::size_t side : sides) {
      if (thin_[side] != 0) beside_[count++] = side;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (thin_[corners[i]] != 0 && thin_[sides[i]] == 0 && thin_[sides[(i + 1) % 4]] == 0) {
        beside_[count++] = corners[i];
      }
    }
    return count;
  }

  /// Node px that are beside each other are one node.
  void make_node(std::uint32_t first) {
    std::vector<std::size_t> px{first};
    skeleton_.nodes.emplace_back();
    SkeletonNode& node = skeleton_.nodes.back();
    const auto number = static_cast<std::uint32_t>(skeleton_.nodes.size());
    node_of_[first] = number;
    for (std::size_t i = 0; i < px.size(); ++i) {
      node.place = node.place + thin_.middle(px[i]);
      node.radius = std::max(node.radius, radius_at(ink_, px[i]));
      const std::size_t count = neighbours(px[i]);
      for (std::size_t k = 0; k < count; ++k) {
        if (thin_[beside_[k]] != k_node || node_of_[beside_[k]] != 0) continue;
        node_of_[beside_[k]] = number;
        px.push_back(beside_[k]);
      }
    }
    node.place = node.place * (1.0 / static_cast<double>(px.size()));
    node.reach = 1.5 * node.radius + 1;
  }

  void follow_from(std::size_t begin) {
    const std::size_t count = neighbours(begin);
    const auto around = beside_;
    for (std::size_t k = 0; k < count; ++k) {
      if (thin_[around[k]] != k_line) continue;
      SkeletonEdge edge;
      edge.nodes[0] = node_of_[begin] - 1U;
      edge.points.push_back(thin_.middle(begin));
      const std::size_t end = walk(begin, around[k], edge);
      if (end == 0) continue;
      edge.points.push_back(thin_.middle(end));
      edge.nodes[1] = node_of_[end] - 1U;
      for (const std::size_t node : edge.nodes) ++skeleton_.nodes[node].degree;
      skeleton_.edges.push_back(std::move(edge));
    }
  }

  void follow_loop(std::size_t begin) {
    SkeletonEdge edge;
    edge.points.push_back(thin_.middle(begin));
    neighbours(begin);
    const std::size_t next = beside_[0];
    thin_[begin] = k_done;
    walk(begin, next, edge);
    edge.points.push_back(edge.points.front());
    skeleton_.edges.push_back(std::move(edge));
  }

  /// Walks along a line to the node at its end, which it returns; 0 where there is none.
  std::size_t walk(std::size_t from, std::size_t at, SkeletonEdge& edge) {
    double sum = 0;
    std::size_t steps = 0;
    while (thin_[at] == k_line) {
      thin_[at] = k_done;
      edge.points.push_back(thin_.middle(at));
      if (edge.points.size() % k_radius_every == 0) {
        sum += radius_at(ink_, at);
        ++steps;
      }
      const std::size_t count = neighbours(at);
      std::size_t next = 0;
      for (std::size_t k = 0; k < count; ++k) {
        if (beside_[k] != from && thin_[beside_[k]] != k_done) next = beside_[k];
      }
      from = at;
      if (next == 0) break;
      at = next;
    }
    edge.radius = steps > 0 ? sum / static_cast<double>(steps) : radius_at(ink_, from);
    return thin_[at] == k_node ? at : 0;
  }

  Bitmap ink_;
  Bitmap thin_;
  std::vector<std::uint32_t> node_of_;
  std::array<std::size_t, 8> beside_{};
  Skeleton skeleton_;
};

}  // namespace

double SkeletonEdge::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += geometry::distance(points[i - 1], points[i]);
  return sum;
}

geometry::PxPoint SkeletonEdge::along(std::size_t side, double distance) const {
  const auto at = [&](std::size_t i) { return side == 0 ? points[i] : points[points.size() - 1 - i]; };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = geometry::distance(at(i - 1), at(i));
    if (distance <= step) return step > 0 ? at(i - 1) + (at(i) - at(i - 1)) * (distance / step) : at(i);
    distance -= step;
  }
  return at(points.size() - 1);
}

geometry::PxPoint leaving_direction(const Skeleton& skeleton, const SkeletonEdge& edge, std::size_t side) {
  const SkeletonNode& node = skeleton.nodes[edge.nodes[side]];
  // A short one has no more than its other end.
  const geometry::PxPoint begin = edge.length() > 2 * node.reach ? edge.along(side, node.reach) : node.place;
  const geometry::PxPoint way = edge.along(side, node.reach + std::max(k_look_px, 4 * node.radius)) - begin;
  const double length = std::sqrt(geometry::dot(way, way));
  return length > 0 ? way * (1 / length) : geometry::PxPoint{1, 0};
}

Skeleton find_skeleton(Bitmap ink) { return SkeletonFinder(std::move(ink)).find(); }

}  // namespace penpose::io
