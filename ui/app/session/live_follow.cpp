#include "ui/app/session/live_follow.h"

#include <algorithm>
#include <limits>

#include "core/document/commands/apply.h"
#include "core/document/drawing/pose_problem.h"
#include "core/document/drawing/pulled_target.h"
#include "core/document/drawing/target_line.h"
#include "core/drawing/live_target.h"

namespace penpose::app {
namespace {

/// The target's line as a view shows it.
document::DrawnTarget seen_from(const document::DrawnTarget& target, const document::View& view,
                                const geometry::Camera& camera) {
  if (target.view == view) return target;
  document::DrawnTarget seen = target;
  seen.line.clear();
  seen.pressure.clear();
  // Only the proportions of pressures count, and the weights have kept them.
  double strongest = 1e-9;
  for (const double weight : target.weights) strongest = std::max(strongest, weight);
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    const auto px = camera.project(target.points[i]);
    if (!px) continue;
    seen.line.push_back(*px);
    seen.pressure.push_back(i < target.weights.size() ? target.weights[i] / strongest : 1.0);
  }
  return seen;
}

std::optional<document::CurveId> curve_of(const document::Command& command) {
  if (const auto* drawn = command.get_if<document::DrawTarget>()) return drawn->curve;
  if (const auto* over = command.get_if<document::OversketchTarget>()) return over->curve;
  return std::nullopt;
}

}  // namespace

void LiveFollow::begin(const document::Document& document, const drawing::Tool& tool, const document::View& view,
                       const curve::Stroke& stroke) {
  end();
  const auto command = drawing::command_of(document, tool, view, stroke, false);
  const auto named = command ? curve_of(*command) : std::nullopt;
  const document::PoseCurve* curve = named ? document::find_curve(document, *named) : nullptr;
  if (curve == nullptr) return;
  start(document, *curve, view);
  whole_.reset();
  if (command->holds<document::OversketchTarget>()) before_ = curve->target;
}

void LiveFollow::begin_drag(const document::Document& document, document::CurveId curve, const document::View& view,
                            const std::optional<PullHold>& pull, bool string) {
  end();
  const document::PoseCurve* found = document::find_curve(document, curve);
  if (found == nullptr || !found->target) return;
  start(document, *found, view);
  pull_ = pull;
  string_ = string;
  if (pull_) pulled_ = found->target;
  if (!string_) return;
  if (!pull_) pull_ = PullHold{{}, 0};
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  pulled_ = found->target;
  if (!camera || pulled_->points.size() != reference_.size()) return;
  // The place of the target that is held is the place as far along the curve.
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  std::vector<curve::PxPoint> seen;
  for (std::size_t i = 0; i < reference_.size(); ++i) {
    const auto wanted = camera->project(pulled_->points[i]);
    const auto is = camera->project(reference_[i]);
    if (!wanted || !is) return;
    seen.push_back(*is);
    if (!(geometry::distance(*wanted, pull_->at) < least)) continue;
    least = geometry::distance(*wanted, pull_->at);
    nearest = i;
  }
  pull_->at = seen[nearest];
  pulled_->points = reference_;
  pulled_->line = std::move(seen);
  pulled_->view = view;
}

bool LiveFollow::begin_pull(const document::Document& document, const document::View& view, const PulledPlace& place) {
  end();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera || place.points.size() < 2) return false;
  document::Document held = document;
  std::erase_if(held.curves, [](const auto& one) { return one->role != document::PoseCurveRole::constraint; });
  intent::IntentProblem problem = document::intent_problem(held);
  // Whatever is free takes the pull: a string goes on where a control that is locked would have led.
  problem.locked.clear();
  intent::DrawnCurve curve{place.points, *camera, {{0, 0}, {1, 0}}, document::hand_px(document, view.viewport), {}};
  document::DrawnTarget is{view, {}, {}, intent::reference_at(*document.model->rig, document.pose, curve), {}};
  for (const geometry::ModelPoint& point : is.points) {
    const auto px = camera->project(point);
    if (!px) return false;
    is.line.push_back(*px);
    is.pressure.push_back(1);
  }
  problem.drawn.insert(problem.drawn.begin(), std::move(curve));
  auto poser = intent::LivePoser::start(*document.model->rig, whole_of(document), std::move(problem));
  if (!poser || poser->variables() == 0) return false;
  model_ = document.model;
  view_ = view;
  reference_ = is.points;
  whole_ = is;
  pull_ = place.hold;
  pulled_ = std::move(is);
  string_ = true;
  poser_.emplace(std::move(*poser));
  return true;
}

bool LiveFollow::pull_string(curve::PxPoint by) {
  // So long a pull tells which controls it means; px of a view 1000 px high.
  constexpr double k_tells_px = 40;
  const double length = geometry::distance(by, {});
  const double tells = std::max(length, k_tells_px * view_.viewport.height / 1000.0);
  const auto pulled = [&](curve::PxPoint way) {
    return document::pulled_target(*pulled_, {curve_, view_, pull_->at, way, pull_->reach});
  };
  const auto now = pulled(by);
  const auto meant = pulled(length > 0 ? by * (tells / length) : curve::PxPoint{0, tells});
  if (!now || !meant) return false;
  return poser_->pull(now->line, meant->line, document::untouched(*pulled_, *meant)).solved;
}

const intent::WholeModel& LiveFollow::whole_of(const document::Document& document) {
  if (whole_rig_ != document.model->rig) {
    whole_model_ = intent::measure_whole_model(*document.model->rig);
    whole_rig_ = document.model->rig;
  }
  return whole_model_;
}

void LiveFollow::start(const document::Document& document, const document::PoseCurve& curve,
                       const document::View& view) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return;
  const auto reference = document::positions_of(document, curve.points);
  auto problem = drawing::live_problem(document, curve, view);
  if (!problem) return;
  auto poser = intent::LivePoser::start(*document.model->rig, whole_of(document), *std::move(problem));
  if (!poser) return;
  model_ = document.model;
  curve_ = curve.id;
  view_ = view;
  reference_ = reference;
  if (curve.target) whole_ = seen_from(*curve.target, view, *camera);
  poser_.emplace(std::move(*poser));
}

bool LiveFollow::follow(const curve::Stroke& stroke) {
  if (!poser_ || stroke.size() < 2) return false;
  const auto line = curve::positions_of(stroke);
  if (!before_) return poser_->follow(line).solved;
  const auto merged = document::drawn_over(*before_, reference_, view_, line);
  if (merged) target_ = *merged;
  return follow_target(merged, *before_);
}

bool LiveFollow::drag(curve::PxPoint by) {
  if (!poser_ || !whole_) return false;
  if (string_ && pulled_) return pull_string(by);
  if (pull_ && pulled_) {
    return follow_target(document::pulled_target(*pulled_, {curve_, view_, pull_->at, by, pull_->reach}), *pulled_);
  }
  auto line = whole_->line;
  for (curve::PxPoint& p : line) p = p + by;
  return follow_target(document::make_target(reference_, view_, line, whole_->pressure), *whole_);
}

bool LiveFollow::follow_target(const base::Result<document::DrawnTarget>& target, const document::DrawnTarget& before) {
  if (!target) return false;
  const auto stays = document::untouched(before, *target);
  if (target->view == view_) return poser_->follow_whole(target->line, stays).solved;
  const auto camera = geometry::Camera::make(view_.camera, view_.viewport);
  return camera && poser_->follow_whole(seen_from(*target, view_, *camera).line, stays).solved;
}

void LiveFollow::end() {
  poser_.reset();
  whole_.reset();
  pull_.reset();
  pulled_.reset();
  string_ = false;
  before_.reset();
  target_.reset();
  model_.reset();
  curve_ = {};
}

document::Command drag_command(const document::PoseCurve& curve, const document::View& view, curve::PxPoint by,
                               const std::optional<PullHold>& pull) {
  if (pull) return document::PullTarget{curve.id, view, pull->at, by, pull->reach};
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!curve.target || curve.target->view == view || !camera) return document::DragTarget{curve.id, by};
  // It was drawn in another view: what is seen now, moved, is drawn in this one.
  const document::DrawnTarget seen = seen_from(*curve.target, view, *camera);
  document::DrawTarget drawn{curve.id, view, seen.line, seen.pressure};
  for (curve::PxPoint& p : drawn.line) p = p + by;
  return drawn;
}

}  // namespace penpose::app
