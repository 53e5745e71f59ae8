#include "core/portrait/sketch/pen_strokes.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/curve/polyline.h"
#include "core/portrait/sketch/habits.h"

namespace penpose::portrait {
namespace {

using geometry::PxPoint;

/// Points around an outline, and how far beside a tip its two sides are compared.
constexpr std::size_t k_outline_points = 128, k_beside_tip = 4;
constexpr std::size_t k_stroke_points = 33;

double area_of(const std::vector<PxPoint>& line) {
  double twice = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const PxPoint& a = line[i];
    const PxPoint& b = line[(i + 1) % line.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::abs(twice);
}

/// The point of a ring at which it turns back most sharply; `far_from` and what is near it are left out.
std::size_t tip_of(const std::vector<PxPoint>& ring, std::size_t far_from) {
  const std::size_t n = ring.size();
  std::size_t best = far_from;
  double least = 1e300;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t apart = i > far_from ? i - far_from : far_from - i;
    if (far_from < n && std::min(apart, n - apart) < n / 4) continue;
    const double across = geometry::distance(ring[(i + n - k_beside_tip) % n], ring[(i + k_beside_tip) % n]);
    if (across >= least) continue;
    least = across;
    best = i;
  }
  return best;
}

}  // namespace

std::vector<PxPoint> middle_of_stroke(const std::vector<PxPoint>& line) {
  const double length = curve::arc_length<PxPoint>(line);
  if (line.size() < 4 || !(length > 0)) return line;
  if (geometry::distance(line.front(), line.back()) > k_ends_meet * length) return line;
  const double thickness = 2 * area_of(line) / length;
  if (!(0.5 * length > k_thin_stroke * thickness)) return line;
  std::vector<PxPoint> closed = line;
  closed.push_back(line.front());
  auto ring = curve::resample<PxPoint>(closed, k_outline_points + 1);
  if (!ring) return line;
  ring->pop_back();
  const std::size_t from = tip_of(*ring, ring->size());
  const std::size_t to = tip_of(*ring, from);
  std::vector<PxPoint> one, other;
  for (std::size_t i = from;; i = (i + 1) % ring->size()) {
    one.push_back((*ring)[i]);
    if (i == to) break;
  }
  for (std::size_t i = from;; i = (i + ring->size() - 1) % ring->size()) {
    other.push_back((*ring)[i]);
    if (i == to) break;
  }
  const auto first = curve::resample<PxPoint>(one, k_stroke_points),
             second = curve::resample<PxPoint>(other, k_stroke_points);
  if (!first || !second) return line;
  std::vector<PxPoint> middle;
  for (std::size_t i = 0; i < k_stroke_points; ++i) middle.push_back(((*first)[i] + (*second)[i]) * 0.5);
  return middle;
}

}  // namespace penpose::portrait
