#include "core/animation/animate_track.h"

#include <algorithm>
#include <cmath>

#include "core/animation/face/contact_share.h"
#include "core/animation/face/gaze.h"
#include "core/animation/face/lid_controls.h"
#include "core/animation/face/lips.h"
#include "core/animation/head/face_depths.h"
#include "core/animation/head/head_fit.h"
#include "core/animation/signal/denoise.h"
#include "core/animation/signal/statistics.h"
#include "core/animation/solve/uncertainty.h"

namespace penpose::animation {

namespace {

/// A face of which the curves span so many px trembles by a px, as trackers go; smaller ones by less.
constexpr double k_usual_span_px = 250;
/// So many frames that are near rest are a better rest than one.
constexpr std::size_t k_enough_alike = 3;

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
    denoise(still, points, tremor_px);
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

/// The deviation of what differs from row to row in a column, from how it bends in most rows; rows in which it rests
/// say nothing.
double trembles(std::span<const std::vector<double>> rows, std::size_t column) {
  std::vector<double> bends;
  for (std::size_t f = 1; f + 1 < rows.size(); ++f) {
    const double bend = rows[f - 1][column] - 2 * rows[f][column] + rows[f + 1][column];
    if (bend != 0) bends.push_back(bend);
  }
  const double of_a_bend = std::sqrt(6.0);
  return spread(bends) / of_a_bend;
}

/// Takes what is left of the tremor out of the solved parameters `searched`. A frame without a face keeps the pose
/// before it; those before the first face stay at rest.
void settle_poses(const rig::Rig& rig, std::span<const std::size_t> searched, const Uncertainty& doubt,
                  std::span<const double> confidence, TrackedAnimation& result) {
  constexpr double k_sharp = 12;    // times the tremor: lips of speech bend by more from one frame to the next
  constexpr double k_trembles = 8;  // times what a control trembles in most frames: what it is in doubt beyond that,
                                    // the few controls that move have settled
  constexpr double k_near = 8;      // deviations: beyond what settling does to controls that do not repeat one another
  std::size_t first = 0;
  while (first < confidence.size() && !(confidence[first] > 0)) ++first;
  const auto solved = shares_of_range(rig, searched, std::span(result.poses).subspan(first));
  auto rows = solved;
  std::vector<double> sharp;
  std::vector<double> tremor;
  for (std::size_t i = 0; i < searched.size(); ++i) {
    tremor.push_back(std::min(doubt.parameters[i], k_trembles * trembles(rows, i)));
    sharp.push_back(k_sharp * doubt.parameters[i]);
  }
  denoise_parameters(tremor, confidence.subspan(first), rows);
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

/// The transfer without the curves that are taken care of.
Transfer without_curves(const Transfer& all, const std::vector<bool>& done) {
  Transfer left;
  left.anchors = all.anchors;
  left.turn_cosine = all.turn_cosine;
  left.turn_sine = all.turn_sine;
  std::vector<std::size_t> place(all.points.size(), 0);
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    place[i] = left.points.size();
    if (done[all.curve[i]]) continue;
    left.points.push_back(all.points[i]);
    left.places.push_back(all.places[i]);
    left.tracked.push_back(all.tracked[i]);
    left.curve.push_back(all.curve[i]);
    left.weights.push_back(all.weights[i]);
    left.scale.push_back(all.scale[i]);
    if (i < all.contact_shares.size()) left.contact_shares.push_back(all.contact_shares[i]);
  }
  for (const auto& pair : all.contacts) {
    if (!done[all.curve[pair[0]]] && !done[all.curve[pair[1]]]) {
      left.contacts.push_back({place[pair[0]], place[pair[1]]});
    }
  }
  for (ContactShare& share : left.contact_shares) {
    for (std::size_t& across : share.across) across = place[across];
  }
  return left;
}

/// The lids of a clip: what they do, and by which controls of the model.
struct Lids {
  std::vector<EyeCurves> eyes;
  std::vector<LidControls> controls;
  EyeMotion motion;
  std::vector<std::vector<GazeControl>> gaze;  ///< one an eye
  std::vector<bool> done;                      ///< curves that the controls take care of
  std::vector<std::size_t> others;             ///< parameters to search for the other parts of the face
};

/// What the action units of a frame say of the controls.
std::vector<Evidence> evidence_of(const rig::Rig& rig, const TrackSetup& setup, const TrackFrame& frame) {
  std::vector<Evidence> evidence;
  for (const UnitControl& one : setup.units) {
    if (one.unit >= frame.says.units.size()) continue;
    const rig::Parameter& range = rig.parameters()[one.parameter];
    const double rest = setup.rest[one.parameter];
    evidence.push_back({one.parameter, rest + frame.says.units[one.unit] * (range.maximum - rest), setup.unit_weight});
  }
  return evidence;
}

/// What the tracker itself says of the eyes' closing, one a frame, or nothing where it says nothing in most frames.
std::vector<double> closing_column(const PointTrack& track) {
  std::vector<double> column;
  std::size_t told = 0;
  double last = 0;
  for (const TrackFrame& frame : track.frames) {
    if (frame.says.closing) {
      last = *frame.says.closing;
      ++told;
    }
    column.push_back(last);
  }
  if (2 * told < track.frames.size()) column.clear();
  return column;
}

/// Root mean square distance of the points from their middle, px; 0 of none.
double extent_of_points(const TrackFrame& frame, std::span<const std::size_t> points) {
  std::vector<PxPoint> places;
  for (const std::size_t i : points) places.push_back(frame.points[i]);
  if (places.empty()) return 0;
  const PxPoint centre = middle(places);
  double sum = 0;
  for (const PxPoint& p : places) sum += (p.x - centre.x) * (p.x - centre.x) + (p.y - centre.y) * (p.y - centre.y);
  return std::sqrt(sum / static_cast<double>(places.size()));
}

/// Errors (place "/curves/N"): a point that the track has not. make_transfer says what else may be wrong.
base::Status check_points(const PointTrack& track, std::span<const TrackedCurve> curves) {
  for (std::size_t c = 0; c < curves.size(); ++c) {
    for (const std::size_t i : curves[c].points) {
      if (i < track.point_count) continue;
      return base::Error{"tracked point " + std::to_string(i) + " does not exist; the track has " +
                             std::to_string(track.point_count) + " points",
                         "/curves/" + std::to_string(c), "use a map for this format"};
    }
  }
  return base::Done{};
}

std::vector<std::vector<double>> openings_of(std::span<const TrackedCurve> curves, std::span<const EyeCurves> eyes,
                                             const StillTrack& still, const TrackFrame& neutral) {
  std::vector<std::vector<double>> all;
  for (const EyeCurves& eye : eyes) all.push_back(openings(still, neutral, curves[eye.one], curves[eye.other]));
  return all;
}

Lids find_lids(const rig::Rig& rig, const TrackSetup& setup, const Transfer& transfer, const geometry::Camera& camera) {
  Lids lids;
  lids.done.assign(setup.curves.size(), false);
  lids.others = setup.free;
  std::vector<EyeCurves> eyes = eyes_of(setup.curves);
  const auto controls = find_lid_controls(rig, setup.rest, setup.free, transfer, eyes, camera);
  for (std::size_t e = 0; e < eyes.size(); ++e) {
    if (controls[e].close.parameters.empty()) continue;
    lids.eyes.push_back(eyes[e]);
    lids.controls.push_back(controls[e]);
    lids.done[eyes[e].one] = lids.done[eyes[e].other] = true;
  }
  // Where nothing but lids is tracked, they are curves like any other.
  if (std::find(lids.done.begin(), lids.done.end(), false) == lids.done.end()) {
    lids.eyes.clear();
    lids.controls.clear();
    lids.done.assign(setup.curves.size(), false);
    return lids;
  }
  if (!lids.eyes.empty()) lids.others = without_lid_controls(rig, setup.rest, setup.free, transfer, lids.eyes, camera);
  lids.gaze = find_gaze_controls(rig, setup.rest, setup.components, transfer, lids.eyes);
  std::erase_if(lids.others, [&](std::size_t p) {
    for (const auto& eye : lids.gaze) {
      if (std::any_of(eye.begin(), eye.end(), [&](const GazeControl& one) { return one.parameter == p; })) return true;
    }
    return std::any_of(lids.controls.begin(), lids.controls.end(), [&](const LidControls& one) {
      const auto has = [&](const LidTravel& way) {
        return std::find(way.parameters.begin(), way.parameters.end(), p) != way.parameters.end();
      };
      return has(one.close) || has(one.widen);
    });
  });
  return lids;
}

/// Lets the eyes look where the person's do, behind lids that are open. The lids follow what is seen of them.
void look_about(const rig::Rig& rig, const TrackSetup& setup, const PointTrack& track, const Lids& lids,
                const StillTrack& still, TrackedAnimation& result) {
  std::size_t controls = 0;
  for (const auto& eye : lids.gaze) controls += eye.size();
  constexpr std::size_t k_eyes = 2;
  if (controls == 0 || lids.eyes.size() != k_eyes) return;
  const auto gaze = gaze_of(track, still, result.eyes.closed);
  if (gaze.empty()) return;
  result.gaze_controls = controls;
  const TrackFrame& neutral = track.frames[still.neutral];
  const auto place = [&](std::size_t e) { return neutral.points[setup.curves[lids.eyes[e].one].points[0]].x; };
  const std::size_t left = place(0) <= place(1) ? 0 : 1;
  for (std::size_t f = 0; f < result.poses.size(); ++f) {
    for (std::size_t e = 0; e < k_eyes; ++e) {
      Gaze at = gaze[e == left ? 0 : 1][f];
      // A look down closes lids too, on most heads; those that a blink closes need not be closed twice.
      constexpr double k_half = 0.5;
      at.down *= std::clamp((1 - result.eyes.closed[e][f]) / k_half, 0.0, 1.0);
      look(rig, setup.rest, lids.gaze[e], at, result.poses[f]);
    }
  }
}

}  // namespace

base::Result<TrackedAnimation> animate_track(const rig::Rig& rig, const PointTrack& track, const TrackSetup& setup,
                                             const geometry::Camera& camera, const FrameWatch& watch) {
  StablePoints points = setup.points;
  points.openings = lid_points(setup.curves);
  auto still = take_head_motion_out(track, points, setup.neutral, setup.least_confidence);
  if (!still) return still.error();
  if (auto known = check_points(track, setup.curves); !known) return known.error();
  see_contacts(track, setup.curves, *still);
  std::optional<RestChoice> rest;
  if (!setup.neutral) {
    const double first_span = setup.curves.empty() ? 0.0 : span_px(setup.curves, track.frames[still->neutral]);
    rest =
        choose_rest(track, *still, setup.curves, setup.tremor_px.value_or(std::min(1.0, first_span / k_usual_span_px)));
    if (rest && rest->frame != still->neutral) {
      still = take_head_motion_out(track, points, rest->frame, setup.least_confidence);
      if (!still) return still.error();
    }
  }
  learn_depths(*still, points.openings, extent_of_points(track.frames[still->neutral], points.stable));
  see_contacts(track, setup.curves, *still);
  auto transfer = make_transfer(rig, setup.rest, track, *still, setup.curves, camera);
  if (!transfer) return transfer.error();
  share_contact(rig, setup.rest, setup.free, track.frames[still->neutral], setup.curves, camera, *transfer);
  const double span = span_px(setup.curves, track.frames[still->neutral]);
  const double tremor_px = setup.tremor_px.value_or(std::min(1.0, span / k_usual_span_px));
  Lids lids = find_lids(rig, setup, *transfer, camera);
  const TrackFrame& neutral = track.frames[still->neutral];
  const auto seen = openings_of(setup.curves, lids.eyes, *still, neutral);
  std::vector<LidPoints> points_of_eyes;
  for (const EyeCurves& eye : lids.eyes) {
    points_of_eyes.push_back(points_of_lids(*still, neutral, setup.curves[eye.one], setup.curves[eye.other]));
  }
  steady_curves(setup.curves, tremor_px, *still);
  if (rest && rest->like_it.size() >= k_enough_alike) {
    measure_from(*still, rest->like_it);
  } else {
    measure_from(*still, still->neutral);
  }
  if (rest) part_lips(setup.curves, neutral, *rest, *still);
  FrameOptions frame = setup.frame;
  frame.tremor_px = tremor_px;
  const Transfer driven = without_curves(*transfer, lids.done);
  auto solver = FrameSolver::make(rig, driven, lids.others, setup.rest, camera, frame);
  if (!solver) return solver.error();

  TrackedAnimation result;
  result.rest = std::move(rest);
  std::vector<double> times_s;
  for (const TrackFrame& one : track.frames) times_s.push_back(one.time_s);
  const double fps = frames_per_second(times_s.front(), times_s.back(), times_s.size());
  result.eyes = find_eye_motion(seen, points_of_eyes, still->confidence, fps, closing_column(track),
                                k_tremor_deviation * tremor_px, still->doubt);
  result.variables = solver->parameters().size();
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    if (watch) watch(false);
    if (still->confidence[f] > 0) {
      const auto told = evidence_of(rig, setup, track.frames[f]);
      solver->follow(still->offsets[f], still->doubt[f], still->confidence[f], told);
    } else {
      result.held.push_back(f);
    }
    if (watch) watch(true);
    result.times_s.push_back(track.frames[f].time_s);
    result.poses.push_back(solver->pose());
  }
  if (tremor_px > 0) {
    const auto searched = solver->parameters();
    const auto doubt = parameter_uncertainty(rig, setup.rest, searched, driven, camera, k_tremor_deviation * tremor_px);
    settle_poses(rig, searched, doubt, still->confidence, result);
  }
  look_about(rig, setup, track, lids, *still, result);
  smooth_over_time(result.times_s, setup.smooth_s, result.poses);
  for (std::size_t f = 0; f < result.poses.size(); ++f) {
    take_apart(rig, setup.rest, solver->opposed(), result.poses[f]);
    std::vector<double> closed;
    for (const auto& eye : result.eyes.closed) closed.push_back(eye[f]);
    if (!closed.empty()) set_lids(rig, lids.controls, closed, result.poses[f]);
  }
  result.still = std::move(still).value();
  result.transfer = std::move(transfer).value();
  return result;
}

}  // namespace penpose::animation
