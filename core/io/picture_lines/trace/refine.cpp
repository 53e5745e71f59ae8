#include <algorithm>
#include <cmath>
#include <utility>

#include "core/curve/polyline.h"
#include "core/io/picture_lines/trace/internal/strokes.h"

namespace penpose::io {
namespace {

using geometry::PxPoint;

constexpr double k_step_px = 0.5;           ///< between samples across a line
constexpr std::ptrdiff_t k_half_chord = 3;  ///< points on each side that give the direction of a line
constexpr std::size_t k_kernel = 7;         ///< points that are smoothed together
constexpr double k_tolerance_px = 0.05;     ///< of the polyline that is left

/// How much ink there is at a place between px.
double weight_at(const Bitmap& weights, PxPoint p) {
  const double x = std::floor(p.x - 0.5);
  const double y = std::floor(p.y - 0.5);
  if (!(x >= -1 && y >= -1 && x < weights.width() && y < weights.height())) return 0;
  const double right = p.x - 0.5 - x;
  const double down = p.y - 0.5 - y;
  const std::size_t at = weights.index(static_cast<int>(x), static_cast<int>(y));
  const std::size_t below = at + weights.stride();
  return (weights[at] * (1 - right) + weights[at + 1] * right) * (1 - down) +
         (weights[below] * (1 - right) + weights[below + 1] * right) * down;
}

/// How far (px) along a normal the middle of the ink is from a place.
double offset_of(const Bitmap& weights, PxPoint p, PxPoint normal, double radius) {
  double sum = weight_at(weights, p);
  double moments = 0;
  for (const double side : {-1.0, 1.0}) {
    for (double s = k_step_px; s <= 2 * radius + 2; s += k_step_px) {
      const double weight = weight_at(weights, p + normal * (side * s));
      if (!(weight > 0)) break;
      sum += weight;
      moments += weight * side * s;
    }
  }
  return sum > 0 ? std::clamp(moments / sum, -radius - 0.5, radius + 0.5) : 0;
}

/// The points of a closed line with some of its other end on each side.
std::vector<PxPoint> unrolled(const std::vector<PxPoint>& points, std::size_t more) {
  std::vector<PxPoint> all(points.end() - 1 - static_cast<std::ptrdiff_t>(more), points.end() - 1);
  all.insert(all.end(), points.begin(), points.end());
  all.insert(all.end(), points.begin() + 1, points.begin() + 1 + static_cast<std::ptrdiff_t>(more));
  return all;
}

/// Keeps the points that a polyline needs to stay within a tolerance (Douglas and Peucker 1973).
std::vector<PxPoint> simplified(const std::vector<PxPoint>& points, double tolerance) {
  std::vector<bool> kept(points.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> runs{{0, points.size() - 1}};
  while (!runs.empty()) {
    const auto [first, last] = runs.back();
    runs.pop_back();
    std::size_t furthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double share = geometry::nearest_share(points[i], points[first], points[last]);
      const double off = geometry::distance(points[i], points[first] + (points[last] - points[first]) * share);
      if (off > most) {
        most = off;
        furthest = i;
      }
    }
    if (furthest == first) continue;
    kept[furthest] = true;
    runs.push_back({first, furthest});
    runs.push_back({furthest, last});
  }
  std::vector<PxPoint> left;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) left.push_back(points[i]);
  }
  return left;
}

}  // namespace

void refine(TracedStroke& stroke, const Bitmap& weights) {
  if (stroke.points.size() < 3) return;
  const std::size_t more = stroke.closed ? std::min<std::size_t>(stroke.points.size() - 1, k_kernel) : 0;
  std::vector<PxPoint> points = stroke.closed ? unrolled(stroke.points, more) : stroke.points;
  const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
  std::vector<PxPoint> middles = points;
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    const PxPoint chord = points[static_cast<std::size_t>(std::min(last, i + k_half_chord))] -
                          points[static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, i - k_half_chord))];
    const double length = std::sqrt(geometry::dot(chord, chord));
    if (!(length > 0)) continue;
    const PxPoint normal = PxPoint{-chord.y, chord.x} * (1 / length);
    const auto at = static_cast<std::size_t>(i);
    middles[at] = points[at] + normal * offset_of(weights, points[at], normal, stroke.radius);
  }
  points = curve::triangle_filter<PxPoint>(middles, k_kernel, curve::Ends::fixed);
  if (stroke.closed) {
    const auto cut = static_cast<std::ptrdiff_t>(more);
    points = std::vector<PxPoint>(points.begin() + cut, points.end() - cut);
    points.back() = points.front();
  }
  stroke.points = simplified(points, k_tolerance_px);
}

}  // namespace penpose::io
