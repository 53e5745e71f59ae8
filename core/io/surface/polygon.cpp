#include "core/io/surface/polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace penpose::io {
namespace {

// Cutting ears takes quadratic time; a polygon of more corners than this is no work of a modeller.
constexpr std::size_t k_most_ear_corners = 500;

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners seen along the polygon's area vector (Newell's method), counter-clockwise.
std::vector<glm::dvec2> flatten(std::span<const std::uint32_t> corners, std::span<const mesh::ModelPoint> positions) {
  glm::dvec3 area(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    // Relative to the first corner, which keeps the digits of a small polygon far from the origin.
    const glm::dvec3 a = positions[corners[i]] - positions[corners[0]];
    const glm::dvec3 b = positions[corners[(i + 1) % corners.size()]] - positions[corners[0]];
    area += glm::cross(a, b);
  }
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(area[i]) > std::abs(area[axis])) axis = i;
  }
  const double sign = area[axis] < 0.0 ? -1.0 : 1.0;
  std::vector<glm::dvec2> flat;
  for (const std::uint32_t v : corners) {
    flat.emplace_back(positions[v][(axis + 1) % 3], sign * positions[v][(axis + 2) % 3]);
  }
  return flat;
}

bool is_ear(const std::vector<glm::dvec2>& flat, const std::vector<std::size_t>& left, std::size_t k) {
  const std::size_t n = left.size();
  const glm::dvec2& a = flat[left[(k + n - 1) % n]];
  const glm::dvec2& b = flat[left[k]];
  const glm::dvec2& c = flat[left[(k + 1) % n]];
  if (!(cross(a, b, c) > 0.0)) return false;
  return std::none_of(left.begin(), left.end(), [&](std::size_t i) {
    const glm::dvec2& p = flat[i];
    if (p == a || p == b || p == c) return false;
    return cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0;
  });
}

}  // namespace

void triangulate(std::span<const std::uint32_t> corners, std::span<const mesh::ModelPoint> positions,
                 std::vector<mesh::Triangle>& out) {
  const auto fan = [&](const std::vector<std::size_t>& left) {
    for (std::size_t i = 1; i + 1 < left.size(); ++i) {
      out.push_back({corners[left[0]], corners[left[i]], corners[left[i + 1]]});
    }
  };
  std::vector<std::size_t> left(corners.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  if (corners.size() <= 3 || corners.size() > k_most_ear_corners) return fan(left);
  const auto flat = flatten(corners, positions);
  if (corners.size() == 4) {
    const bool convex = cross(flat[0], flat[1], flat[2]) > 0.0 && cross(flat[1], flat[2], flat[3]) > 0.0 &&
                        cross(flat[2], flat[3], flat[0]) > 0.0 && cross(flat[3], flat[0], flat[1]) > 0.0;
    if (convex) {
      const double first = geometry::distance(positions[corners[0]], positions[corners[2]]);
      const double second = geometry::distance(positions[corners[1]], positions[corners[3]]);
      return fan(second < first ? std::vector<std::size_t>{1, 2, 3, 0} : left);
    }
  }
  while (left.size() > 3) {
    std::size_t k = 0;
    while (k < left.size() && !is_ear(flat, left, k)) ++k;
    if (k == left.size()) break;
    const std::size_t n = left.size();
    out.push_back({corners[left[(k + n - 1) % n]], corners[left[k]], corners[left[(k + 1) % n]]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
  }
  fan(left);
}

}  // namespace penpose::io
