#include "core/drawing/live_target.h"

#include <algorithm>
#include <memory>

#include "core/document/commands/apply.h"
#include "core/document/drawing/moment.h"
#include "core/document/drawing/pose_problem.h"

namespace penpose::drawing {

std::optional<intent::IntentProblem> live_problem(const document::Document& document, const document::PoseCurve& curve,
                                                  const document::View& view) {
  if (!geometry::Camera::make(view.camera, view.viewport)) return std::nullopt;
  const auto reference = document::positions_of(document, curve.points);
  document::Document drawn = document;
  for (auto& one : drawn.curves) {
    if (one->id != curve.id) continue;
    auto with_target = *one;
    with_target.target = document::DrawnTarget{view, {{0, 0}, {1, 0}}, {1, 1}, reference, {}};
    one = std::make_shared<const document::PoseCurve>(std::move(with_target));
  }
  const auto asked_in = [&](const document::Moment& moment) {
    intent::IntentProblem problem = document::moment_problem(drawn, moment);
    if (problem.drawn.empty() || problem.drawn.back().before) problem.drawn.clear();
    std::rotate(problem.drawn.begin(), problem.drawn.end() - (problem.drawn.empty() ? 0 : 1), problem.drawn.end());
    return problem;
  };
  auto problem = asked_in(document::moment_of(drawn, curve.id));
  if (problem.drawn.empty()) problem = asked_in(document::lone_moment(drawn, curve.id));
  if (problem.drawn.empty()) return std::nullopt;
  problem.drawn.front().doubt_px = document::hand_px(document, view.viewport);
  problem.drawn.front().weights.clear();
  return problem;
}

}  // namespace penpose::drawing
