#include "ui/app/live_follow.h"

#include "core/document/apply.h"
#include "core/document/target_line.h"

namespace penpose::app {
namespace {

/// The target's line as a view shows it.
document::DrawnTarget seen_from(const document::DrawnTarget& target, const document::View& view,
                                const geometry::Camera& camera) {
  if (target.view == view) return target;
  document::DrawnTarget seen = target;
  seen.line.clear();
  seen.pressure.clear();
  for (const auto& point : target.points) {
    if (const auto px = camera.project(point)) seen.line.push_back(*px);
  }
  seen.pressure.assign(seen.line.size(), 1.0);
  return seen;
}

std::optional<document::CurveId> curve_of(const document::Command& command) {
  if (const auto* drawn = std::get_if<document::DrawTarget>(&command)) return drawn->curve;
  if (const auto* over = std::get_if<document::OversketchTarget>(&command)) return over->curve;
  return std::nullopt;
}

}  // namespace

void LiveFollow::begin(const document::Document& document, const drawing::Tool& tool, const document::View& view,
                       const curve::Stroke& stroke) {
  end();
  const auto command = drawing::command_of(document, tool, view, stroke, false);
  const auto named = command ? curve_of(*command) : std::nullopt;
  const document::PoseCurve* curve = named ? document::find_curve(document, *named) : nullptr;
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (curve == nullptr || !camera) return;
  const auto triangles = document.model->mesh->triangles();
  const auto points_of = [&](const document::PoseCurve& one) {
    std::vector<posing::CurvePoint> points;
    for (const auto& point : one.points) points.push_back(posing::at_mesh_point(point, triangles));
    return points;
  };
  posing::PoseProblem whole = document::pose_problem(document);
  posing::LiveSetup setup{
      points_of(*curve), std::move(whole.constraints), std::move(whole.free), std::move(whole.start), *camera, {}};
  // Targets of other references hold their curves where they are wanted, as the solve at pen-up will.
  for (const auto& other : document.curves) {
    if (other->id == curve->id || !other->target) continue;
    setup.constraints.push_back({points_of(*other), other->target->points});
  }
  auto poser = posing::LivePoser::start(*document.model->rig, std::move(setup));
  if (!poser) return;
  model_ = document.model;
  curve_ = curve->id;
  if (std::holds_alternative<document::OversketchTarget>(*command) && curve->target) {
    over_ = seen_from(*curve->target, view, *camera);
  }
  poser_.emplace(std::move(*poser));
}

bool LiveFollow::follow(const curve::Stroke& stroke) {
  if (!poser_ || stroke.size() < 2) return false;
  const auto line = curve::positions_of(stroke);
  if (!over_) return poser_->follow(line).evaluations > 0;
  const auto merged = document::oversketched({over_->line, over_->pressure}, line);
  return merged && poser_->follow(merged->points).evaluations > 0;
}

void LiveFollow::end() {
  poser_.reset();
  over_.reset();
  model_.reset();
  curve_ = {};
}

}  // namespace penpose::app
