#include "core/intent/problem.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/curve/polyline.h"
#include "core/posing/curve_system.h"

namespace penpose::intent {
namespace {

std::string named(const char* kind, std::size_t index) { return std::string(kind) + " " + std::to_string(index); }

/// The known curves, the constraints and the drawn references as curves with targets, for the checks that all share.
posing::PoseProblem as_pose_problem(const IntentProblem& problem) {
  posing::PoseProblem plain;
  for (const DrawnCurve& curve : problem.drawn)
    plain.pairs.push_back(
        {curve.reference, std::vector<ModelPoint>(curve.reference.size(), ModelPoint{0}), curve.weights});
  for (const KnownCurve& curve : problem.known) plain.pairs.push_back({curve.reference, curve.target, {}});
  for (const KnownCurve& curve : problem.kept) plain.constraints.push_back({curve.reference, curve.target});
  plain.free = problem.free;
  plain.start = problem.start;
  return plain;
}

/// Less is no width: its square has no place in a double.
constexpr double k_least_doubt = 1e-30;

/// Why the reference of a drawn curve cannot be seen in its view, if it cannot.
std::optional<base::Error> unseen(const rig::Rig& rig, const rig::Pose& pose, const DrawnCurve& curve) {
  std::vector<PxPoint> seen;
  for (const ModelPoint& p : reference_at(rig, pose, curve)) {
    const auto px = curve.camera.project(p);
    if (!px)
      return base::Error{"the reference curve lies behind the camera", "", "turn the view so that it is visible"};
    seen.push_back(*px);
  }
  if (seen.size() < 2 || !(curve::arc_length<PxPoint>(seen) > 0.0))
    return base::Error{"the reference curve has no length in this view", "",
                       "turn the view so that the curve is visible"};
  return std::nullopt;
}

}  // namespace

double doubt_px(geometry::Viewport viewport) { return k_doubt_px * viewport.height / 1000.0; }

double stroke_doubt_px(std::span<const PxPoint> line, double hand_px) {
  // What is small is drawn with more care.
  hand_px = std::clamp(0.02 * curve::arc_length(line), 0.3 * hand_px, hand_px);
  constexpr std::size_t k_samples = 61;
  const auto even = curve::resample<PxPoint>(line, k_samples);
  if (!even) return hand_px;
  const auto smooth = curve::triangle_filter<PxPoint>(*even, 7, curve::Ends::fixed);
  double sum = 0;
  for (std::size_t i = 0; i < k_samples; ++i) {
    // Across the line alone: the filter's cut kernel pulls points along it near the ends.
    const PxPoint ahead = smooth[std::min(i + 1, k_samples - 1)] - smooth[i > 0 ? i - 1 : 0];
    const PxPoint d = (*even)[i] - smooth[i];
    const double length = geometry::distance(ahead, {});
    const double across = length > 0.0 ? (d.x * ahead.y - d.y * ahead.x) / length : 0.0;
    sum += across * across;
  }
  // A corner that is meant is rounded by the filter, too: only what passes a half of the hand's own doubt counts.
  const double rough = std::sqrt(sum / k_samples);
  return hand_px + std::max(0.0, rough - 0.5 * hand_px);
}

std::vector<ModelPoint> reference_at(const rig::Rig& rig, const rig::Pose& pose, const DrawnCurve& curve) {
  posing::PoseProblem alone;
  alone.pairs.push_back({curve.reference, std::vector<ModelPoint>(curve.reference.size(), ModelPoint{0}), {}});
  alone.start = pose;
  posing::CurveSystem system(rig, alone);
  std::vector<ModelPoint> positions(system.point_count());
  system.positions(pose, positions);
  return positions;
}

base::Status check_problem(const rig::Rig& rig, const IntentProblem& problem) {
  if (auto status = posing::check_problem(rig, as_pose_problem(problem)); !status) return status.error();
  const bool ascending =
      std::adjacent_find(problem.locked.begin(), problem.locked.end(), std::greater_equal<>()) == problem.locked.end();
  if (!ascending || (!problem.locked.empty() && problem.locked.back() >= rig.parameters().size()))
    return base::Error{"what is locked is no list of parameters", "locked", "name parameters of the rig, ascending"};
  const bool taught_fits = problem.taught.empty() || problem.taught.size() == rig.parameters().size();
  if (!taught_fits ||
      !std::all_of(problem.taught.begin(), problem.taught.end(), [](double by) { return std::isfinite(by); }))
    return base::Error{"what choices taught does not fit the rig", "taught", "give a number for each parameter"};
  if (!problem.posed.empty()) {
    posing::PoseProblem plain = as_pose_problem(problem);
    plain.start = problem.posed;
    if (auto status = posing::check_problem(rig, plain); !status) return status.error();
  }
  for (std::size_t i = 0; i < problem.drawn.size(); ++i) {
    const DrawnCurve& curve = problem.drawn[i];
    const bool aside = curve.aside.empty() || curve.aside.size() == curve.reference.size();
    const bool finite = std::all_of(curve.aside.begin(), curve.aside.end(),
                                    [](const ModelVector& v) { return std::isfinite(v.x + v.y + v.z); });
    if (!curve.stays.empty() && curve.stays.size() != curve.reference.size())
      return base::Error{"what stays of the reference does not fit it", named("curve", i),
                         "say of each point, or none"};
    if (!aside || !finite)
      return base::Error{"what is beside the reference does not fit it", named("curve", i), "give one vector a point"};
    if (curve.reference.size() < 2)
      return base::Error{"the reference curve has fewer than two points", named("curve", i), "draw a longer line"};
    if (auto error = unseen(rig, problem.start, curve)) {
      error->place = named("curve", i);
      return *error;
    }
    for (const PxPoint& p : curve.target) {
      if (!(std::abs(p.x) <= 1e6 && std::abs(p.y) <= 1e6))
        return base::Error{"the target lies a million px away", named("curve", i), "draw it on the screen"};
    }
    if (curve.target.size() < 2 || !(curve::arc_length<PxPoint>(curve.target) >= k_shortest_px))
      return base::Error{"the target has no length", named("curve", i), "draw a longer line"};
    if (!(curve.doubt_px >= k_least_doubt) || !std::isfinite(curve.doubt_px))
      return base::Error{"the width of doubt is no positive number", named("curve", i), "give some px"};
  }
  for (const auto* curves : {&problem.known, &problem.kept}) {
    for (std::size_t i = 0; i < curves->size(); ++i) {
      if (!((*curves)[i].doubt >= k_least_doubt) || !std::isfinite((*curves)[i].doubt))
        return base::Error{"the width of doubt is no positive number", named("curve", i), "give some model units"};
    }
  }
  return base::Done{};
}

}  // namespace penpose::intent
