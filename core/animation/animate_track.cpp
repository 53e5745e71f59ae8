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
/// is one movement, and what one lid leaves in doubt about it, all of them tell.
void steady_curves(std::span<const TrackedCurve> curves, double tremor_px, StillTrack& still) {
  std::vector<std::size_t> done;
  const auto steady_new = [&](std::vector<std::size_t> points) {
    std::stable_sort(points.begin(), points.end());
    std::erase_if(points, [&](std::size_t i) { return std::find(done.begin(), done.end(), i) != done.end(); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    steady(still, points, tremor_px);
    done.insert(done.end(), points.begin(), points.end());
  };
  steady_new(lid_points(curves));
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

/// Values of the parameters `searched` as shares of their ranges, one row a pose.
std::vector<std::vector<double>> shares_of_range(const rig::Rig& rig, std::span<const std::size_t> searched,
                                                 std::span<const rig::Pose> poses) {
  std::vector<std::vector<double>> rows;
  for (const rig::Pose& pose : poses) {
    std::vector<double>& row = rows.emplace_back();
    for (const std::size_t p : searched) {
      const rig::Parameter& range = rig.parameters()[p];
      row.push_back((pose[p] - range.minimum) / (range.maximum - range.minimum));
    }
  }
  return rows;
}

/// Keeps a settled row near the solved one along every direction, by so many of its deviations: what is well seen as
/// a sum of controls stays, however much in doubt each of them is.
void hold_near(std::span<const double> solved, const Uncertainty& doubt, double deviations, std::span<double> row) {
  const std::size_t n = row.size();
  std::vector<double> change(n);
  for (std::size_t i = 0; i < n; ++i) change[i] = row[i] - solved[i];
  for (std::size_t d = 0; d < n; ++d) {
    double along = 0;
    for (std::size_t i = 0; i < n; ++i) along += doubt.directions[d * n + i] * change[i];
    const double most = deviations * doubt.deviations[d];
    const double beyond = along - std::clamp(along, -most, most);
    for (std::size_t i = 0; i < n && beyond != 0; ++i) row[i] -= doubt.directions[d * n + i] * beyond;
  }
}

/// Takes what is left of the tremor out of the solved parameters `searched`. A frame without a face keeps the pose
/// before it; those before the first face stay at rest.
void settle_poses(const rig::Rig& rig, std::span<const std::size_t> searched, const Uncertainty& doubt,
                  std::span<const double> confidence, TrackedAnimation& result) {
  constexpr double k_sharp = 5;  // times the tremor: a lid of a blink bends by more from one frame to the next
  constexpr double k_near = 8;   // deviations: beyond what settling does to controls that do not repeat one another
  std::size_t first = 0;
  while (first < confidence.size() && !(confidence[first] > 0)) ++first;
  const auto solved = shares_of_range(rig, searched, std::span(result.poses).subspan(first));
  auto rows = solved;
  std::vector<double> sharp;
  for (const double deviation : doubt.parameters) {
    sharp.push_back(k_sharp * deviation);
  }
  settle(doubt.parameters, confidence.subspan(first), rows);
  round_corners(sharp, rows);
  for (std::size_t f = first; f < result.poses.size(); ++f) {
    std::vector<double>& row = rows[f - first];
    hold_near(solved[f - first], doubt, k_near, row);
    for (std::size_t i = 0; i < searched.size(); ++i) {
      const rig::Parameter& range = rig.parameters()[searched[i]];
      double& value = result.poses[f][searched[i]];
      // By the difference, so that a control that rests does so exactly.
      value += (row[i] - solved[f - first][i]) * (range.maximum - range.minimum);
      value = std::clamp(value, range.minimum, range.maximum);
    }
  }
  for (const std::size_t f : result.held) {
    if (f > first) result.poses[f] = result.poses[f - 1];
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
  FrameOptions frame = setup.frame;
  frame.tremor_px = tremor_px;
  auto solver = FrameSolver::make(rig, *transfer, setup.free, setup.rest, camera, frame);
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
    settle_poses(rig, searched, doubt, still->confidence, result);
  }
  smooth_over_time(result.times_s, setup.smooth_s, result.poses);
  result.still = std::move(still).value();
  result.transfer = std::move(transfer).value();
  return result;
}

}  // namespace penpose::animation
