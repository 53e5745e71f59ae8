#include "core/geometry/lasso.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace penpose::geometry {
namespace {

constexpr std::size_t k_run_length = 16;

double squared(PxPoint v) { return v.x * v.x + v.y * v.y; }

double squared_distance_to_segment(PxPoint p, PxPoint a, PxPoint b) {
  return squared((p - a) - (b - a) * nearest_share(p, a, b));
}

double squared_distance_to_box(PxPoint p, PxPoint minimum, PxPoint maximum) {
  return squared(
      {std::max({minimum.x - p.x, 0.0, p.x - maximum.x}), std::max({minimum.y - p.y, 0.0, p.y - maximum.y})});
}

}  // namespace

base::Result<Lasso> Lasso::make(std::span<const PxPoint> curve) {
  std::vector<PxPoint> points;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const PxPoint p = curve[i];
    if (!(std::abs(p.x) <= k_largest_px && std::abs(p.y) <= k_largest_px)) {
      return base::Error{"a point of the curve lies beyond a million px", std::to_string(i), "draw it again"};
    }
    if (points.empty() || !(points.back() == p)) points.push_back(p);
  }
  while (points.size() > 1 && points.back() == points.front()) points.pop_back();
  if (points.size() < 3) {
    return base::Error{"the curve encloses nothing: it has fewer than three distinct points", "",
                       "draw around the region"};
  }
  Lasso lasso;
  for (std::size_t i = 0; i < points.size(); ++i) lasso.edges_.push_back({points[i], points[(i + 1) % points.size()]});
  for (std::size_t begin = 0; begin < lasso.edges_.size(); begin += k_run_length) {
    Run run{begin, std::min(begin + k_run_length, lasso.edges_.size()), lasso.edges_[begin].from,
            lasso.edges_[begin].from};
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const PxPoint to = lasso.edges_[i].to;
      run.minimum = {std::min(run.minimum.x, to.x), std::min(run.minimum.y, to.y)};
      run.maximum = {std::max(run.maximum.x, to.x), std::max(run.maximum.y, to.y)};
    }
    lasso.runs_.push_back(run);
  }
  return lasso;
}

bool Lasso::contains(PxPoint p) const {
  bool inside = false;
  for (const Run& run : runs_) {
    if (p.y < run.minimum.y || p.y > run.maximum.y || p.x > run.maximum.x) continue;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      const auto& [a, b] = edges_[i];
      // An end exactly at this height counts as below, so that a ray through a corner crosses one edge or both.
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
    }
  }
  return inside;
}

double Lasso::distance(PxPoint p) const {
  double nearest = squared_distance_to_segment(p, edges_.front().from, edges_.front().to);
  for (const Run& run : runs_) {
    if (squared_distance_to_box(p, run.minimum, run.maximum) >= nearest) continue;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      nearest = std::min(nearest, squared_distance_to_segment(p, edges_[i].from, edges_[i].to));
    }
  }
  return std::sqrt(nearest);
}

}  // namespace penpose::geometry
