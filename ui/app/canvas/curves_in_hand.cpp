#include "ui/app/canvas/curves_in_hand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/articulation/edit.h"
#include "core/curve/polyline.h"
#include "core/document/drawing/target_line.h"
#include "ui/app/canvas/place_under.h"
#include "ui/app/view/shown_features.h"
#include "ui/app/view/user_messages.h"

namespace penpose::app {
namespace {

constexpr double k_click_px = 5;
constexpr double k_lit_px = 8;
constexpr double k_touched_px = 10;

std::vector<PxPoint> seen(std::span<const geometry::ModelPoint> line, const geometry::Camera& camera) {
  std::vector<PxPoint> points;
  for (const auto& point : line) {
    if (const auto px = camera.project(point)) points.push_back(*px);
  }
  return points;
}

}  // namespace

void CurvesInHand::hover(PxPoint at, bool on_canvas) {
  lit_.reset();
  if (!on_canvas || parts_.editing.pen_is_drawing() || parts_.editing.document().curves.empty()) return;
  lit_ = curve_near(parts_.editing, parts_.canvas.surface(), at, k_lit_px * parts_.canvas.scale());
}

void CurvesInHand::delete_lit() {
  if (lit_) parts_.editing.perform(document::DeleteCurve{*lit_});
  lit_.reset();
}

void CurvesInHand::keep_lit() {
  if (lit_) parts_.editing.perform(document::KeepCurve{*lit_});
}

void CurvesInHand::forget() {
  lit_.reset();
  target_.reset();
  control_target_.reset();
  place_.reset();
  character_.reset();
  parts_.panels.curve_menu.reset();
  parts_.panels.feature_menu.reset();
}

void CurvesInHand::add_to(CurveLook& look, PxPoint at) const {
  look.highlighted = lit_;
  if (control_target_) {
    look.control_target = control_target_->first;
    look.dragged_by = at - control_target_->second;
    look.pulled = pull_;
  }
  if (target_) {
    look.dragged = target_->first;
    look.dragged_by = at - target_->second;
    look.pulled = pull_;
  }
}

bool CurvesInHand::is_far(PxPoint by) const { return std::hypot(by.x, by.y) > k_click_px * parts_.canvas.scale(); }

std::optional<document::CurveId> CurvesInHand::name_at(PxPoint at) const {
  for (const auto& [id, area] : parts_.panels.face_labels) {
    if (area.holds(at)) return id;
  }
  return std::nullopt;
}

void CurvesInHand::press(PxPoint at) {
  parts_.tool.press(at);
  parts_.controls.lent().press();
  parts_.panels.curve_menu.reset();
  parts_.panels.feature_menu.reset();
  pressed_ = at;
  touches_ = true;
  character_.reset();
  if (parts_.tool.now().pulls) return take_place(at);
  if (parts_.tool.now().places) {
    character_ = parts_.cast.touched(at);
    parts_.cast.take_in_hand(at);
    return;
  }
  named_ = name_at(at);
  if (named_ && parts_.tool.now().selects) return;
  if (parts_.tool.now().selects) select_at(at);
}

void CurvesInHand::hold_line(const std::vector<geometry::ModelPoint>& line, PxPoint at) {
  pull_ = PullHold{at, curve::k_usual_reach};
  const document::View& view = parts_.canvas.view();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  const auto points = camera ? seen(line, *camera) : std::vector<PxPoint>();
  // The middle of a target moves all of it; of a short line most would be its middle.
  constexpr double k_handle_px = 14;
  constexpr double k_handle_share = 0.15;  // of the length of a line, at most
  const double handle =
      std::min(k_handle_px * parts_.canvas.scale(), k_handle_share * curve::arc_length<PxPoint>(points));
  const bool at_middle = !points.empty() && geometry::distance(points[points.size() / 2], at) < handle;
  if (whole_ || at_middle) pull_.reset();
}

bool CurvesInHand::take_control_target(PxPoint at) {
  const auto& deformers = parts_.editing.document().model->deformers;
  const std::string control = parts_.controls.shown();
  const auto number =
      deformers && parts_.panels.controls_tab ? articulation::find_deformer(*deformers, control) : std::nullopt;
  const document::View& view = parts_.canvas.view();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!number || !camera) return false;
  const articulation::Deformer& deformer = *deformers->deformers()[*number];
  const auto near = [&](std::span<const geometry::ModelPoint> line) {
    return document::come_near(seen(line, *camera), std::array<PxPoint, 1>{at}, k_touched_px * parts_.canvas.scale());
  };
  for (std::size_t i = 0; i < deformer.betweens().size(); ++i) {
    if (!near(deformer.betweens()[i])) continue;
    control_target_.emplace(deformer.sketch().betweens[i].value, at);
    hold_line(deformer.betweens()[i], at);
    return true;
  }
  if (!near(deformer.target())) return false;
  control_target_.emplace(1.0, at);
  hold_line({deformer.target().begin(), deformer.target().end()}, at);
  return true;
}

std::optional<document::PullBetween> CurvesInHand::control_pull(PxPoint at) const {
  const PxPoint by = at - control_target_->second;
  if (!is_far(by)) return std::nullopt;
  return document::PullBetween{
      parts_.controls.selected(), control_target_->first, parts_.editing.editor().view(), control_target_->second, by,
      pull_ ? pull_->reach : 0.0};
}

void CurvesInHand::select_at(PxPoint at) {
  target_.reset();
  control_target_.reset();
  parts_.editing.shown().hold_control_target(std::nullopt);
  touched_.reset();
  parts_.panels.curve_menu.reset();
  lit_ = curve_near(parts_.editing, parts_.canvas.surface(), at, k_touched_px * parts_.canvas.scale());
  if (lit_) {
    const auto* curve = document::find_curve(parts_.editing.document(), *lit_);
    if (curve != nullptr && curve->target) {
      target_.emplace(*lit_, at);
      hold_line(curve->target->points, at);
    }
    touched_ = *lit_;
    return;
  }
  if (take_control_target(at)) return;
  character_ = parts_.cast.touched(at);
  if (!character_) select_control_at(at);
}

void CurvesInHand::select_control_at(PxPoint at) {
  const document::View& view = parts_.canvas.view();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return;
  const auto hit = parts_.canvas.surface().pick(*camera, at);
  const document::Model& model = *parts_.editing.document().model;
  parts_.controls.select({});
  if (!hit || !model.deformers) return;
  const std::uint32_t vertex = model.mesh->triangles()[hit->triangle][0];
  double best = 0;
  for (const auto& deformer : model.deformers->deformers()) {
    const auto vertices = deformer->vertices();
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), vertex);
    if (found == vertices.end() || *found != vertex) continue;
    const double weight = deformer->weights()[static_cast<std::size_t>(found - vertices.begin())];
    if (weight <= best) continue;
    best = weight;
    parts_.controls.select(deformer->sketch().name);
    parts_.panels.controls_tab = true;
  }
}

void CurvesInHand::take_place(PxPoint at) {
  named_.reset();
  touched_.reset();
  target_.reset();
  control_target_.reset();
  place_.reset();
  parts_.performer.ready();
  lit_ = curve_near(parts_.editing, parts_.canvas.surface(), at, k_touched_px * parts_.canvas.scale());
  const auto* curve = lit_ ? document::find_curve(parts_.editing.document(), *lit_) : nullptr;
  if (curve != nullptr && curve->target) {
    target_.emplace(*lit_, at);
    hold_line(curve->target->points, at);
    return;
  }
  const auto found =
      place_under(parts_.editing, parts_.canvas.surface(), parts_.canvas.view(), at, 0.5 * parts_.canvas.target_px());
  if (!found) return parts_.notices.tell("There is nothing under the pen: press on the face and pull");
  if (parts_.editing.shown().hold_place(found->place)) {
    place_ = at;
    return;
  }
  const std::string only = parts_.restriction.words();
  parts_.notices.tell(only.empty() ? "Nothing moves here: pull a brow, a lid, the mouth or the jaw"
                                   : "Nothing that may move is here (" + only + "): pull there, or free all controls");
}

void CurvesInHand::move(PxPoint at) {
  parts_.tool.move(at);
  if (place_) return parts_.editing.shown().pull_place(at - *place_);
  touches_ = touches_ && !is_far(at - pressed_);
  if (parts_.tool.now().places && parts_.cast.several() && !touches_) parts_.cast.drag_to(at);
  if (control_target_) parts_.editing.shown().hold_control_target(control_pull(at));
  if (!target_) return;
  const PxPoint by = at - target_->second;
  if (is_far(by)) parts_.editing.shown().hold_target(target_->first, by, pull_);
}

void CurvesInHand::end_performance() {
  if (!parts_.performer.end())
    parts_.notices.tell("the take moved nothing, so nothing is keyed: pull a feature of the face");
  target_.reset();
  place_.reset();
  parts_.editing.shown().let_place_go();
  parts_.editing.shown().hold_target(std::nullopt);
  touched_.reset();
}

bool CurvesInHand::take_feature(PxPoint at) {
  const bool asked = parts_.panels.feature_menu.has_value();
  if (!asked && touches_ && !named_ && !touched_ && !target_ && !control_target_) {
    if (const auto name = feature_at(at)) parts_.panels.feature_menu = FeatureMenu{*name, {}, {}, {}, at};
  }
  if (!parts_.panels.feature_menu) return false;
  // What the menu asks is no failure.
  parts_.notices.take_away([](const Notice& one) { return one.text.starts_with(k_nothing_changed); });
  touched_.reset();
  return true;
}

std::optional<std::string> CurvesInHand::feature_at(PxPoint at) const {
  for (const auto& [name, area] : parts_.panels.feature_labels) {
    if (area.holds(at)) return name;
  }
  const bool all =
      parts_.features.shown() || parts_.tool.now().kind == drawing::ToolKind::feature || parts_.tool.now().selects;
  if (!all || !parts_.panels.shown) return std::nullopt;
  return shown_feature_near(parts_.editing, parts_.canvas.surface(), at, k_lit_px * parts_.canvas.scale());
}

void CurvesInHand::release(PxPoint at) {
  parts_.tool.release();
  parts_.controls.show_new();
  parts_.controls.lent().release();
  if (const auto character = std::exchange(character_, std::nullopt); character && touches_)
    return parts_.cast.ask_for(*character);
  if (parts_.tool.now().places) return;
  if (!parts_.tool.now().pulls && take_feature(at)) return;
  // A line may begin at a name; a touch of it is no line.
  if (const auto named = std::exchange(named_, std::nullopt); named && !is_far(at - pressed_)) {
    parts_.notices.take_away([](const Notice& one) { return one.text.starts_with(k_nothing_changed); });
    parts_.panels.curve_menu = {*named, at};
    return;
  }
  if (control_target_) {
    const auto pull = control_pull(at);
    control_target_.reset();
    parts_.editing.shown().hold_control_target(std::nullopt);
    if (pull) parts_.editing.perform(*pull);
    return;
  }
  if (parts_.performer.performing()) return end_performance();
  if (std::exchange(place_, std::nullopt)) return parts_.editing.shown().let_place_go();
  if (target_) {
    const auto [id, from] = *std::exchange(target_, std::nullopt);
    parts_.editing.shown().hold_target(std::nullopt);
    const auto* curve = document::find_curve(parts_.editing.document(), id);
    if (curve != nullptr && is_far(at - from)) {
      parts_.editing.perform(drag_command(*curve, parts_.editing.editor().view(), at - from, pull_));
      return;
    }
  }
  if (!touched_) return;
  parts_.panels.curve_menu = {*touched_, at};
  touched_.reset();
}

}  // namespace penpose::app
