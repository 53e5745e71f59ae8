#include "core/animation/face/lips.h"

#include <algorithm>
#include <cmath>

#include "core/animation/face/lids.h"
#include "core/animation/head/head_fit.h"
#include "core/animation/signal/statistics.h"

namespace penpose::animation {

void see_contacts(const PointTrack& track, std::span<const TrackedCurve> curves, StillTrack& still) {
  const auto lips = lips_of(curves);
  if (!lips) return;
  const auto& neutral = track.frames[still.neutral].points;
  for (const auto& [a, b] : points_across(curves[lips->one], curves[lips->other], track.frames[still.neutral])) {
    if (a == b) continue;
    for (std::size_t f = 0; f < still.offsets.size(); ++f) {
      auto& offsets = still.offsets[f];
      if (offsets.empty()) continue;
      const auto& p = track.frames[f].points;
      const auto& r = still.turns[f].rotation;
      const double determinant = (r[0][0] * r[1][1] - r[1][0] * r[0][1]) * still.turns[f].scale;
      if (!(std::abs(determinant) > 0.1 * still.turns[f].scale)) continue;
      const PxPoint d = p[b] - p[a];
      const PxPoint turned{(r[1][1] * d.x - r[1][0] * d.y) / determinant,
                           (r[0][0] * d.y - r[0][1] * d.x) / determinant};
      const PxPoint more = (turned - (neutral[b] - neutral[a]) - (offsets[b] - offsets[a])) * 0.5;
      offsets[a] = offsets[a] - more;
      offsets[b] = offsets[b] + more;
    }
  }
}

void part_lips(std::span<const TrackedCurve> curves, const TrackFrame& neutral, const RestChoice& rest,
               StillTrack& still) {
  const auto lips = lips_of(curves);
  if (!lips) return;
  const auto& gap = openings(still, neutral, curves[lips->one], curves[lips->other]);
  std::vector<double> at_rest;
  for (const std::size_t f : rest.like_it) at_rest.push_back(gap[f]);
  const double apart = quantile(at_rest, 0.5) - rest.lips_together;
  if (!(apart > 0)) return;
  const auto mean = [&](const TrackedCurve& curve) {
    std::vector<PxPoint> places;
    for (const std::size_t i : curve.points) places.push_back(neutral.points[i]);
    return middle(places);
  };
  const TrackedCurve* upper = &curves[lips->one];
  const TrackedCurve* lower = &curves[lips->other];
  if (geometry::distance(mean(*upper), still.pivot) > geometry::distance(mean(*lower), still.pivot)) {
    std::swap(upper, lower);
  }
  const PxPoint corner = neutral.points[lower->points.front()];
  const PxPoint line = neutral.points[lower->points.back()] - corner;
  const double width = std::sqrt(line.x * line.x + line.y * line.y);
  if (!(width > 0)) return;
  PxPoint down{-line.y / width, line.x / width};
  const PxPoint below = mean(*lower) - mean(*upper);
  if (down.x * below.x + down.y * below.y < 0) down = down * -1.0;
  const auto height = [&](const PxPoint& p) { return (p.x - corner.x) * down.x + (p.y - corner.y) * down.y; };
  const double line_of_lips = height(mean(*upper));
  // The lower lip's other edge goes along: any curve that lies under its inner one and is about as wide.
  for (const TrackedCurve& curve : curves) {
    if (curve.meets || &curve == upper) continue;
    const double wide = geometry::distance(neutral.points[curve.points.front()], neutral.points[curve.points.back()]);
    const bool is_lower = &curve == lower || (height(mean(curve)) > line_of_lips && wide < 2 * width &&
                                              height(mean(curve)) < line_of_lips + width);
    if (!is_lower || curve.points.size() < 3) continue;
    for (std::size_t k = 1; k + 1 < curve.points.size(); ++k) {
      // The corners stay.
      const double t = static_cast<double>(k) / static_cast<double>(curve.points.size() - 1);
      const double share = std::min(1.0, 6 * t * (1 - t));
      for (auto& offsets : still.offsets) {
        if (!offsets.empty()) offsets[curve.points[k]] = offsets[curve.points[k]] + down * (share * apart);
      }
    }
  }
}

}  // namespace penpose::animation
