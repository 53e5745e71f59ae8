#include "core/curve/sheets.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/mesh/topology.h"

namespace penpose::curve {
namespace {

/// Of the reach, so that no rounding counts.
constexpr double k_beyond = 1.000001;

/// The square of segment_distance, here where it is asked for most.
inline double squared_distance(const ModelPoint& a0, const ModelPoint& a1, const ModelPoint& b0, const ModelPoint& b1) {
  // Ericson 2005, Real-Time Collision Detection, section 5.1.9.
  const ModelPoint u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double uu = glm::dot(u, u), vv = glm::dot(v, v), uv = glm::dot(u, v), uw = glm::dot(u, w), vw = glm::dot(v, w);
  double s = 0, t = 0;
  if (uu > 0 && vv > 0) {
    const double across = uu * vv - uv * uv;
    if (across > 1e-12 * uu * vv) s = std::clamp((uv * vw - uw * vv) / across, 0.0, 1.0);
    t = (uv * s + vw) / vv;
    if (t < 0) {
      t = 0;
      s = std::clamp(-uw / uu, 0.0, 1.0);
    } else if (t > 1) {
      t = 1;
      s = std::clamp((uv - uw) / uu, 0.0, 1.0);
    }
  } else if (uu > 0) {
    s = std::clamp(-uw / uu, 0.0, 1.0);
  } else if (vv > 0) {
    t = std::clamp(vw / vv, 0.0, 1.0);
  }
  const ModelPoint way = (a0 + u * s) - (b0 + v * t);
  return way.x * way.x + way.y * way.y + way.z * way.z;
}

}  // namespace

Sheets::Sheets(const mesh::TriangleMesh& mesh) : Sheets(mesh, mesh.triangles()) {}

Sheets::Sheets(const mesh::TriangleMesh& mesh, std::span<const mesh::Triangle> triangles)
    : triangles_(triangles.begin(), triangles.end()),
      beside_(triangles.size(), {k_border, k_border, k_border}),
      seen_(triangles.size(), 0) {
  const auto weld = mesh.weld();
  areas_.assign(mesh.component_count(), 0.0);
  for (const mesh::Triangle& t : triangles_) {
    const ModelPoint a(mesh.positions()[t[0]]), b(mesh.positions()[t[1]]), c(mesh.positions()[t[2]]);
    areas_[mesh.components()[t[0]]] += 0.5 * geometry::length(glm::cross(b - a, c - a));
  }
  for (const double area : areas_) largest_area_ = std::max(largest_area_, area);
  std::vector<mesh::Triangle> welded = triangles_;
  for (mesh::Triangle& triangle : welded) {
    component_.push_back(mesh.components()[triangle[0]]);
    for (std::uint32_t& vertex : triangle) vertex = weld[vertex];
  }
  const auto join = [&](const mesh::EdgeUse& use, std::uint32_t other) {
    const mesh::Triangle& t = welded[use.triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (std::min(a, b) == use.low && std::max(a, b) == use.high) beside_[use.triangle][k] = other;
    }
  };
  const auto edges = mesh::sorted_edges(welded, mesh.vertex_count());
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high;) ++end;
    // All triangles at an edge reach each other, three and more in a ring.
    for (std::size_t k = i; end - i > 1 && k < end; ++k) join(edges[k], edges[k + 1 < end ? k + 1 : i].triangle);
  }
}

bool Sheets::joined(const Place& a, const Place& b, double reach, std::span<const glm::vec3> positions) {
  if (a.triangle == b.triangle) return true;
  if (component_[a.triangle] != component_[b.triangle]) return false;
  if (++search_ == 0) {
    std::fill(seen_.begin(), seen_.end(), 0U);
    search_ = 1;
  }
  queue_.assign(1, a.triangle);
  seen_[a.triangle] = search_;
  // An edge that lies beside the box about the line is farther than that from the line itself; most are.
  const ModelPoint least = glm::min(a.position, b.position) - k_beyond * reach;
  const ModelPoint most = glm::max(a.position, b.position) + k_beyond * reach;
  const auto beside_box = [&](const glm::vec3& from, const glm::vec3& to) {
    for (int axis = 0; axis < 3; ++axis) {
      if (static_cast<double>(std::min(from[axis], to[axis])) > most[axis]) return true;
      if (static_cast<double>(std::max(from[axis], to[axis])) < least[axis]) return true;
    }
    return false;
  };
  const ModelPoint along = b.position - a.position;
  const double square_along = glm::dot(along, along);
  const double inverse = square_along > 0.0 ? 1.0 / square_along : 0.0;
  // An edge that starts near the line is near it.
  const auto starts_near = [&](const glm::vec3& from) {
    const ModelPoint to = ModelPoint(from) - a.position;
    const ModelPoint off = to - along * std::clamp(glm::dot(to, along) * inverse, 0.0, 1.0);
    return k_beyond * glm::dot(off, off) < reach * reach;
  };
  const auto is_far = [&](const glm::vec3& from, const glm::vec3& to) {
    if (starts_near(from)) return false;
    // The root is drawn only where rounding could tell.
    const double square = squared_distance(a.position, b.position, ModelPoint(from), ModelPoint(to));
    if (square > k_beyond * reach * reach) return true;
    return k_beyond * square > reach * reach && std::sqrt(square) > reach;
  };
  for (std::size_t next = 0; next < queue_.size(); ++next) {
    // On a mesh that is much finer than the hand everything near is one sheet: no walk is to take long.
    if (queue_.size() > k_most_visited) return geometry::distance(a.position, b.position) <= reach;
    const std::uint32_t triangle = queue_[next];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t beside = beside_[triangle][k];
      if (beside == k_border || seen_[beside] == search_) continue;
      const glm::vec3& from = positions[triangles_[triangle][k]];
      const glm::vec3& to = positions[triangles_[triangle][(k + 1) % 3]];
      if (beside_box(from, to)) continue;
      if (is_far(from, to)) continue;
      if (beside == b.triangle) return true;
      seen_[beside] = search_;
      queue_.push_back(beside);
    }
  }
  return false;
}

double segment_distance(const ModelPoint& a0, const ModelPoint& a1, const ModelPoint& b0, const ModelPoint& b1) {
  return std::sqrt(squared_distance(a0, a1, b0, b1));
}

}  // namespace penpose::curve
