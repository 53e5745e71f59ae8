#include "core/animation/animate_track.h"

#include <algorithm>

#include "core/animation/steady.h"

namespace penpose::animation {

namespace {

/// Steadies every curve and what it rides on, each point once.
void steady_curves(std::span<const TrackedCurve> curves, double tremor_px, StillTrack& still) {
  std::vector<std::size_t> done;
  const auto steady_new = [&](const std::vector<std::size_t>& points) {
    std::vector<std::size_t> fresh;
    for (const std::size_t i : points) {
      if (std::find(done.begin(), done.end(), i) == done.end()) fresh.push_back(i);
    }
    steady(still, fresh, tremor_px);
    done.insert(done.end(), fresh.begin(), fresh.end());
  };
  for (const TrackedCurve& curve : curves) steady_new(curve.points);
  for (const TrackedCurve& curve : curves) steady_new(curve.anchor);
}

}  // namespace

base::Result<TrackedAnimation> animate_track(const rig::Rig& rig, const PointTrack& track, const TrackSetup& setup,
                                             const geometry::Camera& camera, const FrameWatch& watch) {
  auto still = take_head_motion_out(track, setup.points, setup.neutral, setup.least_confidence);
  if (!still) return still.error();
  auto transfer = make_transfer(rig, setup.rest, track, *still, setup.curves, camera);
  if (!transfer) return transfer.error();
  steady_curves(setup.curves, setup.tremor_px, *still);
  auto solver = FrameSolver::make(rig, *transfer, setup.free, setup.rest, camera, setup.frame);
  if (!solver) return solver.error();

  TrackedAnimation result;
  result.variables = solver->variables();
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
  if (setup.tremor_px > 0) {
    std::vector<double> tremor(rig.parameters().size(), 0.0);
    constexpr double k_share = 0.03;  // of a range: what is left of the tremor in parameters that move little
    for (const std::size_t p : setup.free)
      tremor[p] = k_share * (rig.parameters()[p].maximum - rig.parameters()[p].minimum);
    settle(tremor, result.poses);
  }
  smooth_over_time(result.times_s, setup.smooth_s, result.poses);
  result.still = std::move(still).value();
  result.transfer = std::move(transfer).value();
  return result;
}

}  // namespace penpose::animation
