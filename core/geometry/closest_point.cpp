#include "core/geometry/closest_point.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "core/base/math.h"

namespace penpose::geometry {
namespace {

constexpr std::uint32_t k_leaf_size = 4;
constexpr std::size_t k_deepest = 64;  // the tree halves its triangles, so that 2^32 of them fit

struct OnTriangle {
  std::array<double, 3> barycentric;
  ModelPoint point;
};

/// The closest point of a triangle, by the region of the plane that the point falls into (Ericson 2005, section 5.1.5).
/// Coordinates of corners that have no part in it are exactly zero.
OnTriangle closest_on_triangle(const ModelPoint& p, const ModelPoint& a, const ModelPoint& b, const ModelPoint& c) {
  const ModelVector ab = b - a;
  const ModelVector ac = c - a;
  const ModelVector ap = p - a;
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {{1, 0, 0}, a};
  const ModelVector bp = p - b;
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {{0, 1, 0}, b};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double t = d1 - d3 > 0.0 ? d1 / (d1 - d3) : 0.0;
    return {{1 - t, t, 0}, a + ab * t};
  }
  const ModelVector cp = p - c;
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {{0, 0, 1}, c};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double t = d2 - d6 > 0.0 ? d2 / (d2 - d6) : 0.0;
    return {{1 - t, 0, t}, a + ac * t};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double sum = (d4 - d3) + (d5 - d6);
    const double t = sum > 0.0 ? (d4 - d3) / sum : 0.0;
    return {{0, 1 - t, t}, b + (c - b) * t};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0.0)) return {{1, 0, 0}, a};  // a needle without area whose rounding fits no region
  const double v = vb / sum;
  const double w = vc / sum;
  return {{1 - v - w, v, w}, a + ab * v + ac * w};
}

double squared_distance(const ModelPoint& p, const Box& box) {
  const ModelVector d = glm::max(glm::max(box.minimum - p, p - box.maximum), ModelVector{0});
  return glm::dot(d, d);
}

struct TriangleEdge {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t triangle;
  std::uint32_t opposite;
};

}  // namespace

ClosestPointTree::ClosestPointTree(std::span<const ModelPoint> positions,
                                   std::span<const std::array<std::uint32_t, 3>> triangles)
    : positions_(positions.begin(), positions.end()), triangles_(triangles.begin(), triangles.end()) {
  for (const auto& [a, b, c] : triangles_) {
    centers_.push_back((positions_[a] + positions_[b] + positions_[c]) * (1.0 / 3.0));
  }
  order_.resize(triangles_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(triangles_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(order_.size()));
  make_normals();
}

void ClosestPointTree::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
  Box centers;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const std::uint32_t v : triangles_[order_[i]]) nodes_[node].box.add(positions_[v]);
    centers.add(centers_[order_[i]]);
  }
  nodes_[node].first = begin;
  nodes_[node].count = end - begin;
  if (end - begin <= k_leaf_size) return;
  const ModelVector extent = centers.maximum - centers.minimum;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::stable_sort(order_.begin() + begin, order_.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
    return centers_[a][axis] != centers_[b][axis] ? centers_[a][axis] < centers_[b][axis] : a < b;
  });
  const auto left = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = left;
  nodes_[node].count = 0;
  nodes_.resize(nodes_.size() + 2);
  build(left, begin, middle);
  build(left + 1, middle, end);
}

void ClosestPointTree::make_normals() {
  corner_normals_.assign(positions_.size(), ModelVector{0});
  edge_normals_.resize(triangles_.size());
  std::vector<TriangleEdge> edges;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const auto& corners = triangles_[t];
    const ModelVector across =
        glm::cross(positions_[corners[1]] - positions_[corners[0]], positions_[corners[2]] - positions_[corners[0]]);
    const ModelVector normal = normalized(across, ModelVector{0});
    face_normals_.push_back(normal);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t next = corners[(i + 1) % 3];
      const std::uint32_t last = corners[(i + 2) % 3];
      const ModelVector to_next = normalized(positions_[next] - positions_[corners[i]], ModelVector{0});
      const ModelVector to_last = normalized(positions_[last] - positions_[corners[i]], ModelVector{0});
      corner_normals_[corners[i]] += normal * base::acos(glm::dot(to_next, to_last));
      edges.push_back({std::min(next, last), std::max(next, last), t, i});
    }
  }
  std::stable_sort(edges.begin(), edges.end(), [](const TriangleEdge& a, const TriangleEdge& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.triangle != b.triangle ? a.triangle < b.triangle : a.opposite < b.opposite;
  });
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    ModelVector sum{0};
    for (; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end) {
      sum += face_normals_[edges[end].triangle];
    }
    for (; i < end; ++i) edge_normals_[edges[i].triangle][edges[i].opposite] = sum;
  }
}

ModelVector ClosestPointTree::normal_at(std::uint32_t triangle, const std::array<double, 3>& b) const {
  const ModelVector face = normalized(face_normals_[triangle]);
  int zeros = 0;
  std::uint32_t zero = 0;
  std::uint32_t corner = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (b[i] == 0.0) {
      ++zeros;
      zero = i;
    } else {
      corner = i;
    }
  }
  if (zeros == 2) return normalized(corner_normals_[triangles_[triangle][corner]], face);
  if (zeros == 1) return normalized(edge_normals_[triangle][zero], face);
  return face;
}

ClosestPoint ClosestPointTree::closest(const ModelPoint& point) const {
  struct Visit {
    std::uint32_t node;
    double squared;
  };
  std::array<Visit, 2 * k_deepest> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, squared_distance(point, nodes_[0].box)};
  double nearest = std::numeric_limits<double>::infinity();
  ClosestPoint best;
  best.triangle = 0xffffffffU;
  while (depth > 0) {
    const Visit visit = stack[--depth];
    if (visit.squared > nearest) continue;
    const Node& node = nodes_[visit.node];
    if (node.count == 0) {
      Visit near{node.first, squared_distance(point, nodes_[node.first].box)};
      Visit far{node.first + 1, squared_distance(point, nodes_[node.first + 1].box)};
      if (far.squared < near.squared) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t t = order_[i];
      const auto& [a, b, c] = triangles_[t];
      const OnTriangle on = closest_on_triangle(point, positions_[a], positions_[b], positions_[c]);
      const ModelVector d = point - on.point;
      const double squared = glm::dot(d, d);
      if (squared > nearest || (squared == nearest && t > best.triangle)) continue;
      nearest = squared;
      best.triangle = t;
      best.barycentric = on.barycentric;
      best.point = on.point;
    }
  }
  best.distance = std::sqrt(nearest);
  best.normal = normal_at(best.triangle, best.barycentric);
  return best;
}

double ClosestPointTree::signed_distance(const ModelPoint& point) const {
  const ClosestPoint at = closest(point);
  return glm::dot(point - at.point, at.normal) < 0.0 ? -at.distance : at.distance;
}

}  // namespace penpose::geometry
