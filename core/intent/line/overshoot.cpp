#include "core/intent/line/overshoot.h"

#include <algorithm>

#include "core/curve/polyline.h"

namespace penpose::intent {
namespace {

/// The curve's own direction at an end is told by this share of its length.
constexpr double k_told_by = 0.15;
/// Less than this share of the line is no part of it.
constexpr double k_least = 0.005;
/// A hand that goes straight on strays from it by this many times the doubt.
constexpr double k_strays = 2.5;
constexpr std::size_t k_places = 4;

/// From inside the curve to its end, length one.
PxPoint outwards(std::span<const PxPoint> seen, std::span<const double> along, bool last) {
  const std::size_t n = seen.size();
  const double reach = k_told_by * along.back();
  std::size_t inside = last ? n - 2 : 1;
  while (last ? inside > 0 && along.back() - along[inside] < reach : inside + 1 < n && along[inside] < reach)
    inside = last ? inside - 1 : inside + 1;
  const PxPoint way = seen[last ? n - 1 : 0] - seen[inside];
  const double length = geometry::distance(way, {});
  return length > 0.0 ? way * (1.0 / length) : PxPoint{1, 0};
}

}  // namespace

std::array<Overshoot, 2> overshoots(const SlidingLine& line, std::span<const PxPoint> seen, const Alignment& alignment,
                                    const Matching& matching, double doubt) {
  std::array<Overshoot, 2> out;
  const std::vector<double> along = curve::cumulative_length<PxPoint>(seen);
  if (alignment.closed || seen.size() < 2 || !(along.back() > 0.0)) return out;
  const double whole = line.length();
  for (std::size_t which = 0; which < 2; ++which) {
    const bool last = which == 1;
    // Of a reference that was drawn in part, the other end lies elsewhere.
    if (last ? alignment.reference_to < 1.0 : alignment.reference_from > 0.0) continue;
    Overshoot& one = out[which];
    one.end = last ? seen.size() - 1 : 0;
    const double at = std::clamp(matching.along[one.end], 0.0, whole);
    const bool to_start = last == alignment.reversed;  // the line's part from its start to there
    const double length = to_start ? at : whole - at;
    if (length < k_least * whole) continue;
    one.share = length / along.back();
    const PxPoint way = outwards(seen, along, last);
    one.across = {-way.y, way.x};
    std::array<double, k_places> off{};
    double mean = 0;
    for (std::size_t k = 0; k < k_places; ++k) {
      const double step = length * (static_cast<double>(k) + 0.5) / static_cast<double>(k_places);
      const PxPoint p = line.at(to_start ? at - step : at + step);
      one.middle = one.middle + p * (1.0 / static_cast<double>(k_places));
      off[k] = dot(one.across, p);
      mean += off[k] / static_cast<double>(k_places);
    }
    for (const double d : off) one.spread += (d - mean) * (d - mean) / static_cast<double>(k_places);
    const double apart = mean - dot(one.across, seen[one.end]);
    if (apart * apart + one.spread < k_strays * k_strays * doubt * doubt) one.share = 0.0;
  }
  return out;
}

}  // namespace penpose::intent
