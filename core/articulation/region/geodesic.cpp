#include "core/articulation/region/geodesic.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace penpose::articulation {
namespace {

constexpr double k_unreached = std::numeric_limits<double>::infinity();

/// The distance at `c` from the source that lies `to_a` from a and `to_b` from b, in the plane of the triangle and on
/// the other side of a b; along the nearer edge where the straight way leaves the triangle.
double across(const ModelPoint& a, double to_a, const ModelPoint& b, double to_b, const ModelPoint& c) {
  const double along_edges = std::min(to_a + geometry::distance(a, c), to_b + geometry::distance(b, c));
  const ModelVector ab = b - a;
  const double length = std::sqrt(glm::dot(ab, ab));
  if (!(length > 0.0) || !(std::abs(to_a - to_b) < length)) return along_edges;
  const double source_x = (to_a * to_a - to_b * to_b + length * length) / (2.0 * length);
  const double source_square = to_a * to_a - source_x * source_x;
  const double source_y = source_square > 0.0 ? std::sqrt(source_square) : 0.0;
  const ModelVector ac = c - a;
  const double x = glm::dot(ac, ab) / length;
  const double height_square = glm::dot(ac, ac) - x * x;
  const double y = height_square > 0.0 ? std::sqrt(height_square) : 0.0;
  const double rise = source_y + y;
  if (!(rise > 0.0)) return along_edges;
  const double crossing = source_x + (x - source_x) * (source_y / rise);
  if (crossing < 0.0 || crossing > length) return along_edges;
  return std::sqrt((x - source_x) * (x - source_x) + rise * rise);
}

/// Nodes that wait, the nearest first; equal distances come in the order of their nodes, so that there is one order.
class Waiting {
 public:
  [[nodiscard]] bool empty() const { return heap_.empty(); }
  void add(double distance, std::uint32_t node) {
    heap_.emplace_back(distance, node);
    for (std::size_t i = heap_.size() - 1; i > 0 && heap_[i] < heap_[(i - 1) / 2]; i = (i - 1) / 2)
      std::swap(heap_[i], heap_[(i - 1) / 2]);
  }
  std::uint32_t take() {
    const std::uint32_t node = heap_.front().second;
    heap_.front() = heap_.back();
    heap_.pop_back();
    for (std::size_t i = 0;;) {
      std::size_t least = i;
      for (std::size_t child = 2 * i + 1; child <= 2 * i + 2 && child < heap_.size(); ++child) {
        if (heap_[child] < heap_[least]) least = child;
      }
      if (least == i) return node;
      std::swap(heap_[i], heap_[least]);
      i = least;
    }
  }

 private:
  std::vector<std::pair<double, std::uint32_t>> heap_;
};

}  // namespace

std::vector<double> geodesic_distances(const Patch& patch, std::span<const GeodesicSeed> seeds,
                                       std::span<const std::uint8_t> open) {
  std::vector<double> distances(patch.node_count(), k_unreached);
  std::vector<std::uint8_t> known(patch.node_count(), 0);
  Waiting waiting;
  const auto offer = [&](std::uint32_t node, double distance) {
    if (!(distance < distances[node])) return;
    distances[node] = distance;
    waiting.add(distance, node);
  };
  for (const GeodesicSeed& seed : seeds) offer(seed.node, seed.distance);
  const auto rests = patch.rests();
  while (!waiting.empty()) {
    const std::uint32_t at = waiting.take();
    if (known[at] != 0) continue;
    known[at] = 1;
    for (const std::uint32_t t : patch.star(at)) {
      const mesh::Triangle& triangle = patch.triangles()[t];
      const std::size_t corner = triangle[0] == at ? 0 : triangle[1] == at ? 1 : 2;
      const std::uint32_t b = triangle[(corner + 1) % 3];
      const std::uint32_t c = triangle[(corner + 2) % 3];
      for (const auto& [other, wanted] : {std::pair{b, c}, std::pair{c, b}}) {
        if (known[wanted] != 0 || open[wanted] == 0) continue;
        offer(wanted, known[other] != 0
                          ? across(rests[at], distances[at], rests[other], distances[other], rests[wanted])
                          : distances[at] + geometry::distance(rests[at], rests[wanted]));
      }
    }
  }
  return distances;
}

}  // namespace penpose::articulation
