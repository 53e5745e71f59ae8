#include "core/animation/animate_track.h"

#include <algorithm>
#include <cmath>

#include "core/animation/meeting.h"
#include "core/animation/steady.h"
#include "core/animation/uncertainty.h"

namespace penpose::animation {

namespace {

/// A face of which the curves span so many px trembles by a px, as trackers go; smaller ones by less.
constexpr double k_usual_span_px = 250;

std::vector<std::size_t> lid_points(std::span<const TrackedCurve> curves) {
  std::vector<std::size_t> lids;
  for (const TrackedCurve& curve : curves) {
    if (curve.meets) lids.insert(lids.end(), curve.points.begin(), curve.points.end());
  }
  return lids;
}

/// Steadies every point that drives something or carries what does, once. Lids go together, those of both eyes: a blink
/// is one event, and what one lid leaves in doubt about its frames, all of them tell. Other curves move in several ways
/// at once.
void steady_curves(std::span<const TrackedCurve> curves, double tremor_px, StillTrack& still) {
  std::vector<std::size_t> done = lid_points(curves);
  std::stable_sort(done.begin(), done.end());
  done.erase(std::unique(done.begin(), done.end()), done.end());
  steady_together(still, done, tremor_px);
  const auto steady_new = [&](std::vector<std::size_t> points) {
    std::stable_sort(points.begin(), points.end());
    std::erase_if(points, [&](std::size_t i) { return std::find(done.begin(), done.end(), i) != done.end(); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    steady(still, points, tremor_px);
    done.insert(done.end(), points.begin(), points.end());
  };
  for (const TrackedCurve& curve : curves) steady_new(curve.points);
  for (const TrackedCurve& curve : curves) steady_new(curve.anchor);
}

/// Diagonal of the box around the tracked curves in the neutral frame, px.
double span_px(std::span<const TrackedCurve> curves, const TrackFrame& neutral) {
  PxPoint low = neutral.points[curves[0].points[0]];
  PxPoint high = low;
  for (const TrackedCurve& curve : curves) {
    for (const std::size_t i : curve.points) {
      const PxPoint& p = neutral.points[i];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return geometry::distance(low, high);
}

/// Takes what is left of the tremor out of the solved parameters. `doubt`: standard deviation of each parameter of the
/// solver by the tremor of one frame, as a share of its range. A frame without a face keeps the pose before it.
void settle_poses(const rig::Rig& rig, std::span<const std::size_t> searched, std::span<const double> doubt,
                  const StillTrack& still, TrackedAnimation& result) {
  constexpr double k_left = 0.7;  // of the tremor, once the points are steadied
  constexpr double k_sharp = 5;   // times the tremor: a lid of a blink bends by more from one frame to the next
  std::vector<double> tremor(rig.parameters().size(), 0.0);
  std::vector<double> sharp(tremor.size(), 0.0);
  for (std::size_t i = 0; i < searched.size(); ++i) {
    const rig::Parameter& range = rig.parameters()[searched[i]];
    const double deviation = doubt[i] * (range.maximum - range.minimum);
    tremor[searched[i]] = k_left * deviation;
    sharp[searched[i]] = k_sharp * deviation;
  }
  settle(tremor, still.confidence, result.poses);
  round_corners(sharp, result.poses);
  for (std::size_t f = 0; f < result.poses.size(); ++f) {
    for (const std::size_t p : searched) {
      double& value = result.poses[f][p];
      value = std::clamp(value, rig.parameters()[p].minimum, rig.parameters()[p].maximum);
    }
  }
  for (const std::size_t f : result.held) {
    if (f > 0) result.poses[f] = result.poses[f - 1];
  }
}

}  // namespace

base::Result<TrackedAnimation> animate_track(const rig::Rig& rig, const PointTrack& track, const TrackSetup& setup,
                                             const geometry::Camera& camera, const FrameWatch& watch) {
  StablePoints points = setup.points;
  points.openings = lid_points(setup.curves);
  auto still = take_head_motion_out(track, points, setup.neutral, setup.least_confidence);
  if (!still) return still.error();
  auto transfer = make_transfer(rig, setup.rest, track, *still, setup.curves, camera);
  if (!transfer) return transfer.error();
  share_meetings(rig, setup.rest, setup.free, track.frames[still->neutral], setup.curves, camera, *transfer);
  const double span = span_px(setup.curves, track.frames[still->neutral]);
  const double tremor_px = setup.tremor_px.value_or(std::min(1.0, span / k_usual_span_px));
  steady_curves(setup.curves, tremor_px, *still);
  measure_from(*still, still->neutral);
  auto solver = FrameSolver::make(rig, *transfer, setup.free, setup.rest, camera, setup.frame);
  if (!solver) return solver.error();

  TrackedAnimation result;
  result.variables = solver->parameters().size();
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    if (watch) watch(false);
    if (still->confidence[f] > 0) {
      solver->follow(still->offsets[f], still->doubt[f], still->confidence[f]);
    } else {
      result.held.push_back(f);
    }
    if (watch) watch(true);
    result.times_s.push_back(track.frames[f].time_s);
    result.poses.push_back(solver->pose());
  }
  if (tremor_px > 0) {
    const auto searched = solver->parameters();
    const auto doubt =
        parameter_uncertainty(rig, setup.rest, searched, *transfer, camera, k_tremor_deviation * tremor_px);
    settle_poses(rig, searched, doubt, *still, result);
  }
  smooth_over_time(result.times_s, setup.smooth_s, result.poses);
  result.still = std::move(still).value();
  result.transfer = std::move(transfer).value();
  return result;
}

}  // namespace penpose::animation
