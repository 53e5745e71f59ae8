#include "core/curve/pairing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve/polyline.h"

namespace penpose::curve {
namespace {

double sum_of_distances(std::span<const ModelPoint> a, std::span<const ModelPoint> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += geometry::distance(a[i], b[i]);
  return sum;
}

base::Result<PairedTarget> pair_at(std::span<const ModelPoint> reference, std::span<const PxPoint> line,
                                   std::span<const double> shares, const geometry::Camera& camera) {
  const auto points = resample_at(line, shares);
  if (!points) return points.error();
  PairedTarget paired;
  paired.shares.assign(shares.begin(), shares.end());
  for (std::size_t i = 0; i < reference.size(); ++i) paired.points.push_back(lift((*points)[i], reference[i], camera));
  return paired;
}

void count_from_the_other_end(std::vector<double>& shares) {
  for (double& share : shares) share = 1.0 - share;
}

/// The loop with its end joined to its start.
std::vector<PxPoint> joined(std::span<const PxPoint> line) {
  std::vector<PxPoint> loop(line.begin(), line.end());
  if (!(loop.front() == loop.back())) loop.push_back(loop.front());
  return loop;
}

base::Result<PairedTarget> pair_closed(std::span<const ModelPoint> reference, std::span<const double> shares,
                                       std::span<const PxPoint> target, const geometry::Camera& camera) {
  const std::size_t n = reference.size();
  std::vector<PxPoint> loop = joined(target);
  std::optional<PairedTarget> best;
  double least = 0;
  std::vector<double> turned(n);
  for (const bool reversed : {false, true}) {
    if (reversed) std::reverse(loop.begin(), loop.end());
    for (std::size_t shift = 0; shift + 1 < n; ++shift) {
      for (std::size_t i = 0; i < n; ++i) {
        turned[i] = shares[i] + shares[shift];
        if (turned[i] > 1.0) turned[i] -= 1.0;
      }
      auto paired = pair_at(reference, loop, turned, camera);
      if (!paired) return paired;
      const double sum = sum_of_distances(reference, paired->points);
      if (best && sum >= least) continue;
      least = sum;
      best = std::move(paired).value();
      best->reversed = reversed;
      best->shift = shift;
    }
  }
  if (best->reversed) count_from_the_other_end(best->shares);
  return *best;
}

}  // namespace

double pairing_distance_px(geometry::Viewport viewport) { return k_pairing_distance_px * viewport.height / 1000.0; }

bool is_closed(std::span<const PxPoint> line, double distance_px) {
  return line.size() > 2 && geometry::distance(line.front(), line.back()) <= distance_px &&
         arc_length(line) > 4.0 * distance_px;
}

bool runs_backwards(std::span<const PxPoint> reference, std::span<const PxPoint> target) {
  return geometry::distance(target.back(), reference.front()) < geometry::distance(target.front(), reference.front());
}

ModelPoint lift(PxPoint position, const ModelPoint& reference, const geometry::Camera& camera) {
  const geometry::Ray ray = camera.ray(position);
  return ray.origin + ray.direction * geometry::distance(reference, camera.eye());
}

base::Result<PairedTarget> pair_target(std::span<const ModelPoint> reference, std::span<const PxPoint> target,
                                       const geometry::Camera& camera) {
  if (target.size() < 2) return base::Error{"the target has fewer than two points", "", "draw a longer line"};
  std::vector<PxPoint> seen;
  for (const ModelPoint& p : reference) {
    const auto px = camera.project(p);
    if (!px)
      return base::Error{"the reference curve lies behind the camera", "", "turn the view so that it is visible"};
    seen.push_back(*px);
  }
  const auto shares = shares_of<PxPoint>(seen);
  if (!shares)
    return base::Error{"the reference curve has no length in this view", "",
                       "turn the view so that the curve is visible"};
  const double near_px = pairing_distance_px(camera.viewport());
  if (is_closed(seen, near_px) && is_closed(target, near_px)) return pair_closed(reference, *shares, target, camera);
  std::vector<PxPoint> line(target.begin(), target.end());
  const bool reversed = runs_backwards(seen, line);
  if (reversed) std::reverse(line.begin(), line.end());
  auto paired = pair_at(reference, line, *shares, camera);
  if (!paired) return paired;
  paired->reversed = reversed;
  if (reversed) count_from_the_other_end(paired->shares);
  return paired;
}

}  // namespace penpose::curve
