#include "core/animation/face/contact_share.h"

#include <algorithm>

#include "core/animation/solve/seen_points.h"
#include "core/curve/polyline.h"

namespace penpose::animation {
namespace {

std::vector<PxPoint> places_of(const TrackedCurve& curve, const TrackFrame& frame) {
  std::vector<PxPoint> places;
  for (const std::size_t i : curve.points) places.push_back(frame.points[i]);
  return places;
}

/// Where the curve's points are seen, pose by pose.
SeenPoints seen_points(const rig::Rig& rig, const Transfer& transfer, std::size_t curve,
                       const geometry::Camera& camera) {
  std::vector<posing::CurvePoint> points;
  for (std::size_t i = 0; i < transfer.points.size(); ++i) {
    if (transfer.curve[i] == curve) points.push_back(transfer.points[i]);
  }
  return {rig, std::move(points), camera};
}

/// Mean over the curve's points of how far the parameter that moves each the farthest does so within its range, px.
double mobility(const rig::Rig& rig, std::span<const double> rest, std::span<const std::size_t> free,
                SeenPoints curve) {
  const auto still = curve.at(rest);
  std::vector<double> farthest(still.size(), 0.0);
  rig::Pose pose(rest.begin(), rest.end());
  for (const std::size_t p : free) {
    const rig::Parameter& range = rig.parameters()[p];
    for (const double value : {range.minimum, range.maximum}) {
      if (value == rest[p]) continue;
      pose[p] = value;
      const auto moved = curve.at(pose);
      for (std::size_t i = 0; i < still.size(); ++i) {
        farthest[i] = std::max(farthest[i], geometry::distance(moved[i], still[i]));
      }
    }
    pose[p] = rest[p];
  }
  double sum = 0;
  for (const double one : farthest) sum += one;
  return farthest.empty() ? 0.0 : sum / static_cast<double>(farthest.size());
}

/// What lies across point `share` of the way along a curve on the other one, which may run the other way and of which
/// the points begin at `first`.
void find_across(std::size_t first, std::span<const double> shares, double share, bool backwards, ContactShare& out) {
  if (backwards) share = 1.0 - share;
  std::size_t i = 0;
  while (i + 2 < shares.size() && shares[i + 1] < share) ++i;
  const double length = shares[i + 1] - shares[i];
  out.across = {first + i, first + i + 1};
  out.between = length > 0 ? std::clamp((share - shares[i]) / length, 0.0, 1.0) : 0.0;
}

}  // namespace

void share_contact(const rig::Rig& rig, std::span<const double> rest, std::span<const std::size_t> free,
                   const TrackFrame& neutral, std::span<const TrackedCurve> curves, const geometry::Camera& camera,
                   Transfer& transfer) {
  transfer.contact_shares.assign(transfer.points.size(), {});
  std::vector<double> reach(curves.size(), 0.0);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].meets) reach[c] = mobility(rig, rest, free, seen_points(rig, transfer, c, camera));
  }
  const std::vector<std::size_t> firsts = first_points(curves);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!curves[c].meets || curves[*curves[c].meets].meets != c) continue;
    const TrackedCurve& other = curves[*curves[c].meets];
    const double both = reach[c] + reach[*curves[c].meets];
    if (!(both > 0)) continue;
    const auto own_places = places_of(curves[c], neutral);
    const auto other_places = places_of(other, neutral);
    const auto own = curve::shares_of<PxPoint>(own_places);
    const auto shares = curve::shares_of<PxPoint>(other_places);
    if (!own || !shares) continue;
    const auto apart = [&](const PxPoint& a, const PxPoint& b) { return geometry::distance(a, b); };
    const bool backwards =
        apart(own_places.front(), other_places.front()) + apart(own_places.back(), other_places.back()) >
        apart(own_places.front(), other_places.back()) + apart(own_places.back(), other_places.front());
    for (std::size_t i = 0; i < own->size(); ++i) {
      ContactShare& share = transfer.contact_shares[firsts[c] + i];
      find_across(firsts[*curves[c].meets], *shares, (*own)[i], backwards, share);
      share.takes_over = 1.0 - std::min(1.0, 2 * reach[*curves[c].meets] / both);
    }
  }
}

}  // namespace penpose::animation
