#include "core/intent/problem.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/curve/polyline.h"

namespace penpose::intent {
namespace {

std::string named(const char* kind, std::size_t index) { return std::string(kind) + " " + std::to_string(index); }

/// The known curves, the constraints and the drawn references as curves with targets, for the checks that all share.
posing::PoseProblem as_pose_problem(const IntentProblem& problem) {
  posing::PoseProblem plain;
  for (const DrawnCurve& curve : problem.drawn)
    plain.pairs.push_back({curve.reference, std::vector<ModelPoint>(curve.reference.size(), ModelPoint{0}), {}});
  for (const KnownCurve& curve : problem.known) plain.pairs.push_back({curve.reference, curve.target, {}});
  for (const KnownCurve& curve : problem.kept) plain.constraints.push_back({curve.reference, curve.target});
  plain.free = problem.free;
  plain.start = problem.start;
  return plain;
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
    const PxPoint d = (*even)[i] - smooth[i];
    sum += d.x * d.x + d.y * d.y;
  }
  // A corner that is meant is rounded by the filter, too: only what passes a half of the hand's own doubt counts.
  const double rough = std::sqrt(sum / k_samples);
  return hand_px + std::max(0.0, rough - 0.5 * hand_px);
}

base::Status check_problem(const rig::Rig& rig, const IntentProblem& problem) {
  if (auto status = posing::check_problem(rig, as_pose_problem(problem)); !status) return status.error();
  for (std::size_t i = 0; i < problem.drawn.size(); ++i) {
    const DrawnCurve& curve = problem.drawn[i];
    if (curve.reference.size() < 2)
      return base::Error{"the reference curve has fewer than two points", named("curve", i), "draw a longer line"};
    for (const PxPoint& p : curve.target) {
      if (!(std::abs(p.x) <= 1e6 && std::abs(p.y) <= 1e6))
        return base::Error{"the target lies a million px away", named("curve", i), "draw it on the screen"};
    }
    if (curve.target.size() < 2 || !(curve::arc_length<PxPoint>(curve.target) > 0.0))
      return base::Error{"the target has no length", named("curve", i), "draw a longer line"};
    if (!(curve.doubt_px > 0.0) || !std::isfinite(curve.doubt_px))
      return base::Error{"the width of doubt is no positive number", named("curve", i), "give some px"};
    if (!curve.weights.empty() && curve.weights.size() != curve.reference.size())
      return base::Error{"has another number of weights than of points", named("curve", i), "give one weight a point"};
  }
  for (const auto* curves : {&problem.known, &problem.kept}) {
    for (std::size_t i = 0; i < curves->size(); ++i) {
      if (!((*curves)[i].doubt > 0.0) || !std::isfinite((*curves)[i].doubt))
        return base::Error{"the width of doubt is no positive number", named("curve", i), "give some model units"};
    }
  }
  return base::Done{};
}

}  // namespace penpose::intent
