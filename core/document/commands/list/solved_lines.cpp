#include "core/document/commands/list/solved_lines.h"

#include <utility>

#include "core/document/commands/apply_parts.h"
#include "core/document/drawing/moment.h"
#include "core/document/drawing/pose_problem.h"
#include "core/intent/earlier_lines.h"

namespace penpose::document {
namespace {

using geometry::ModelPoint;

/// Other readings that are kept of each line.
constexpr std::size_t k_others = 4;

intent::SolveOptions with_others() {
  intent::SolveOptions options;
  options.others = k_others;
  return options;
}

std::vector<Moment::Other> kept_of(std::vector<intent::OtherReading> others) {
  std::vector<Moment::Other> kept;
  for (intent::OtherReading& one : others) kept.push_back({std::move(one.pose), one.above, one.probability});
  return kept;
}

/// How far what a correction touches is from its target, px in the mean. `stays`: what it does not touch.
double touched_px(const Document& document, const PoseCurve& curve, const std::vector<bool>& stays) {
  const auto camera = geometry::Camera::make(curve.target->view.camera, curve.target->view.viewport);
  const std::vector<ModelPoint> at = positions_of(document, curve.points);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; camera && i < at.size() && i < curve.target->points.size(); ++i) {
    const auto is = camera->project(at[i]);
    const auto wanted = camera->project(curve.target->points[i]);
    if (stays[i] || !is || !wanted) continue;
    sum += geometry::distance(*is, *wanted);
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

Changed solved_for(Document document, CurveId drawn, Parts& work, const std::vector<bool>& stays) {
  Moment moment = moment_of(document, drawn);
  intent::IntentProblem problem = moment_problem(document, moment);
  if (problem.free.empty()) return document;
  const auto asks = [&] { return !problem.drawn.empty() && !problem.drawn.back().before; };
  if (!stays.empty() && asks()) {
    problem.drawn.back().stays = stays;
    problem = intent::with_earlier_constrained(*document.model->rig, problem);
  }
  const auto solve = [&] {
    return intent::solve(*document.model->rig, work.whole_of(document), problem, with_others(), work.meant);
  };
  base::Result<intent::Solution> solution = base::Error{};
  if (asks()) solution = solve();
  if (!solution) {
    // A reference that is seen in the pose alone, not in the one before, for one.
    moment = lone_moment(document, drawn);
    problem = moment_problem(document, moment);
    if (!asks()) return document;
    solution = solve();
    if (!solution) return solution.error();
  }
  document.pose = std::move(solution->pose);
  moment.posed = document.pose;
  moment.others = kept_of(std::move(solution->others));
  moment.probability = solution->probability;
  for (const CurveId anew : drawn_anew(moment)) {
    std::erase_if(document.curves, [&](const auto& curve) { return curve->id == anew; });
    std::erase_if(moment.lines, [&](const auto& line) { return line.curve == anew; });
  }
  document.moment = std::make_shared<const Moment>(std::move(moment));
  return document;
}

Changed corrected(const Document& document, const PoseCurve& other, const std::vector<bool>& stays, Parts& work) {
  constexpr double k_far_share = 0.6;
  constexpr double k_nearer_share = 0.75;
  auto alone = solved_for(with_replaced(document, other), other.id, work, stays);
  if (!alone || stays.empty()) return alone;
  const double left = touched_px(*alone, other, stays);
  if (left <= k_far_share * touched_px(document, other, stays)) return alone;
  auto whole = solved_for(with_replaced(document, other), other.id, work);
  return whole && touched_px(*whole, other, stays) < k_nearer_share * left ? whole : alone;
}

}  // namespace penpose::document
