// One file above the usual size: what pen, mouse and fingers do to the canvas depends on who has it.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/articulation/edit.h"
#include "core/articulation/measure/doubts.h"
#include "core/curve/polyline.h"
#include "core/document/drawing/target_line.h"
#include "ui/app/app.h"
#include "ui/app/input/navigation.h"

// What events do to the app: pens, mouse, fingers and keys.

namespace penpose::app {
namespace {

using decode::PenEventKind;

constexpr double k_degrees_per_px = 0.35;
constexpr double k_zoom_per_px = 0.005;
constexpr double k_zoom_per_notch = 0.9;
constexpr double k_click_px = 5;
/// Of the middle of a target, which moves all of it.
constexpr double k_handle_px = 14;
constexpr double k_handle_share = 0.15;  ///< of the length of a line, at most
/// A mouse and a finger press neither hard nor softly.
constexpr double k_mouse_pressure = 0.5;

}  // namespace

bool App::pen_is_drawing() const { return workspace_.session().pens().current() != nullptr; }

void App::resized(geometry::Viewport window, double dpi) {
  window = {std::clamp(window.width, 1, 16384), std::clamp(window.height, 1, 16384)};
  dpi_ = dpi;
  touch_ = TouchGestures(4 * scale());
  if (window == window_ && view_.viewport == window) return;
  window_ = window;
  view_.viewport = window;
  free_.right = std::max(free_.left + 1, std::min(free_.right, static_cast<double>(window.width)));
  free_.bottom = std::max(free_.top + 1, std::min(free_.bottom, static_cast<double>(window.height)));
  if (framed_) frame_from(viewpoint_);
}

void App::commit_view() {
  if (pen_is_drawing() || (player_ && player_->is_session() && !player_->finished())) return;
  workspace_.set_view(view_);
}

void App::hover_panels(PxPoint at, bool down) {
  // Moves in between tell nothing; presses and releases must not be lost between two frames.
  if (panel_pointer_.size() > 1 && panel_pointer_.back().down == down &&
      panel_pointer_[panel_pointer_.size() - 2].down == down) {
    panel_pointer_.back().at = at;
    return;
  }
  panel_pointer_.push_back({at, down});
}

void App::hover(PxPoint at) {
  at_ = at;
  hover_panels(at, false);
  highlighted_.reset();
  if (hits_.on_canvas(at) && !pen_is_drawing() && !workspace_.document().curves.empty()) {
    highlighted_ = curve_near(workspace_, surface_, at, 8 * scale());
  }
}

void App::pointer_left() { hover_panels({-1e4, -1e4}, false); }

void App::pen_pressed(PxPoint at) {
  if (workspace_.editor().tool().kind == drawing::ToolKind::none) select_at(at);
}

void App::hold_line(const std::vector<geometry::ModelPoint>& line, PxPoint at) {
  pull_ = PullHold{at, curve::k_usual_reach};
  const auto camera = geometry::Camera::make(view_.camera, view_.viewport);
  std::vector<PxPoint> seen;
  for (const auto& point : line) {
    const auto px = camera ? camera->project(point) : std::nullopt;
    if (px) seen.push_back(*px);
  }
  // Of a short line most would be its middle.
  const double handle = std::min(k_handle_px * scale(), k_handle_share * curve::arc_length<PxPoint>(seen));
  const bool at_middle = !seen.empty() && geometry::distance(seen[seen.size() / 2], at) < handle;
  if (whole_ || at_middle) pull_.reset();
}

bool App::take_goal(PxPoint at) {
  const auto& deformers = workspace_.document().model->deformers;
  const auto number =
      deformers && panels_.controls_tab ? articulation::find_deformer(*deformers, panels_.deformer) : std::nullopt;
  const auto camera = geometry::Camera::make(view_.camera, view_.viewport);
  if (!number || !camera) return false;
  const articulation::Deformer& deformer = *deformers->deformers()[*number];
  const auto near = [&](std::span<const geometry::ModelPoint> line) {
    std::vector<PxPoint> seen;
    for (const auto& point : line) {
      if (const auto px = camera->project(point)) seen.push_back(*px);
    }
    return document::come_near(seen, std::array<PxPoint, 1>{at}, 10 * scale());
  };
  for (std::size_t i = 0; i < deformer.betweens().size(); ++i) {
    if (!near(deformer.betweens()[i])) continue;
    goal_drag_.emplace(deformer.sketch().betweens[i].value, at);
    hold_line(deformer.betweens()[i], at);
    return true;
  }
  if (!near(deformer.target())) return false;
  goal_drag_.emplace(1.0, at);
  hold_line({deformer.target().begin(), deformer.target().end()}, at);
  return true;
}

std::optional<document::PullBetween> App::goal_pull(PxPoint at) const {
  const PxPoint by = at - goal_drag_->second;
  if (std::hypot(by.x, by.y) <= k_click_px * scale()) return std::nullopt;
  return document::PullBetween{
      panels_.deformer,          goal_drag_->first, workspace_.editor().view(), goal_drag_->second, by,
      pull_ ? pull_->reach : 0.0};
}

void App::select_at(PxPoint at) {
  target_drag_.reset();
  goal_drag_.reset();
  workspace_.hold_goal(std::nullopt);
  touched_curve_.reset();
  panels_.curve_menu.reset();
  highlighted_ = curve_near(workspace_, surface_, at, 10 * scale());
  if (highlighted_) {
    const auto* curve = document::find_curve(workspace_.document(), *highlighted_);
    if (curve != nullptr && curve->target) {
      target_drag_.emplace(*highlighted_, at);
      hold_line(curve->target->points, at);
    }
    touched_curve_ = *highlighted_;
    return;
  }
  if (take_goal(at)) return;
  const auto camera = geometry::Camera::make(view_.camera, view_.viewport);
  if (!camera) return;
  const auto hit = surface_.pick(*camera, at);
  const auto& deformers = workspace_.document().model->deformers;
  panels_.deformer.clear();
  if (!hit || !deformers) return;
  const std::uint32_t vertex = workspace_.document().model->mesh->triangles()[hit->triangle][0];
  double best = 0;
  for (const auto& deformer : deformers->deformers()) {
    const auto vertices = deformer->vertices();
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), vertex);
    if (found == vertices.end() || *found != vertex) continue;
    const double weight = deformer->weights()[static_cast<std::size_t>(found - vertices.begin())];
    if (weight <= best) continue;
    best = weight;
    panels_.deformer = deformer->sketch().name;
    panels_.controls_tab = true;
  }
}

void App::show_new_deformer() {
  const auto& deformers = workspace_.document().model->deformers;
  const std::size_t count = deformers ? deformers->size() : 0;
  if (count == deformer_count_ + 1 && !workspace_.document().pending) {
    panels_.deformer = deformers->deformers().back()->sketch().name;
    panels_.controls_tab = true;
    tell(panels_.deformer + " is ready: its slider is in the panel");
    for (const std::string& doubt : articulation::doubts_of(*deformers->deformers().back())) tell(doubt);
  }
  deformer_count_ = count;
  const auto& corrections = workspace_.document().model->corrections;
  const std::size_t corrected = corrections ? corrections->size() : 0;
  if (corrected == correction_count_ + 1 && !workspace_.document().pending) {
    const articulation::Correction& one = *corrections->all().back();
    tell(one.drawn.sketch.name + " is there wherever its controls come together");
    for (const std::string& doubt : articulation::doubts_of(*one.deformer)) tell(doubt);
  }
  correction_count_ = corrected;
}

void App::tell_new_doubts() {
  const auto now = workspace_.document().model->deformers;
  const auto before = std::exchange(seen_deformers_, now);
  if (!before || !now || before == now) return;
  for (const auto& deformer : now->deformers()) {
    const auto number = articulation::find_deformer(*before, deformer->sketch().name);
    if (!number || before->deformers()[*number] == deformer) continue;
    const auto known = articulation::doubts_of(*before->deformers()[*number]);
    for (const std::string& doubt : articulation::doubts_of(*deformer)) {
      if (std::find(known.begin(), known.end(), doubt) == known.end()) tell(doubt);
    }
  }
}

void App::pen_moved(PxPoint at) {
  at_ = at;
  const replay::DrawnStroke* stroke = workspace_.session().pens().current();
  const bool sketches = workspace_.editor().tool().kind == drawing::ToolKind::articulate;
  // Only a line begins a control; a tap leaves the face as it is.
  if (sketches && !workspace_.document().pending && stroke != nullptr && stroke->on_canvas && !stroke->eraser &&
      !drawing::is_tap(stroke->samples, stroke->view.viewport)) {
    begin_control();
  }
  if (goal_drag_) workspace_.hold_goal(goal_pull(at));
  if (!target_drag_) return;
  const PxPoint by = at - target_drag_->second;
  if (std::hypot(by.x, by.y) > k_click_px * scale()) workspace_.hold_target(target_drag_->first, by, pull_);
}

void App::pen_released(PxPoint at) {
  show_new_deformer();
  if (goal_drag_) {
    const auto pull = goal_pull(at);
    goal_drag_.reset();
    workspace_.hold_goal(std::nullopt);
    if (pull) workspace_.perform(*pull);
    return;
  }
  if (performance_) {
    if (!end_performance()) tell("the take moved nothing: nothing is keyed");
    target_drag_.reset();
    workspace_.hold_target(std::nullopt);
    touched_curve_.reset();
    return;
  }
  if (target_drag_) {
    const PxPoint by = at - target_drag_->second;
    const auto id = target_drag_->first;
    target_drag_.reset();
    workspace_.hold_target(std::nullopt);
    const auto* curve = document::find_curve(workspace_.document(), id);
    if (curve != nullptr && std::hypot(by.x, by.y) > k_click_px * scale()) {
      workspace_.perform(drag_command(*curve, workspace_.editor().view(), by, pull_));
      return;
    }
  }
  if (touched_curve_) {
    panels_.curve_menu = {*touched_curve_, at};
    touched_curve_.reset();
  }
}

void App::begin_drag(PxPoint at) {
  if (pen_is_drawing()) return;
  drag_ = at;
  drag_moved_ = false;
}

void App::drag_to(PxPoint at, bool pan, bool zoom) {
  if (!drag_) return;
  const PxPoint by = at - *drag_;
  if (!drag_moved_ && std::hypot(by.x, by.y) < k_click_px * scale()) return;
  drag_moved_ = true;
  drag_ = at;
  framed_ = false;
  if (zoom) {
    view_.camera = zoomed(view_, std::exp(by.y * k_zoom_per_px / scale()),
                          {0.5 * view_.viewport.width, 0.5 * view_.viewport.height}, surface_.size());
  } else if (pan) {
    view_.camera = panned(view_, by);
  } else {
    view_.camera = orbited(view_.camera, -by.x * k_degrees_per_px / scale(), by.y * k_degrees_per_px / scale());
  }
}

void App::end_barrel(PxPoint at) {
  const bool clicked = drag_ && !drag_moved_;
  drag_.reset();
  barrel_ = false;
  if (clicked && panels_.dialog == Dialog::none) panels_.radial = at;
}

void App::take_moments(int device, std::span<const replay::PenMoment> moments) {
  for (const replay::PenMoment& moment : moments) {
    at_ = moment.position;
    turn_pen_dials(device, moment);
    switch (moment.kind) {
      case PenEventKind::hover:
        if (barrel_) {
          drag_to(at_, false, false);
        } else if (pen_view_) {
          drag_to(at_, *pen_view_ == ViewHold::move, *pen_view_ == ViewHold::zoom);
        } else {
          hover(at_);
        }
        place_pen();
        break;
      case PenEventKind::button_down:
      case PenEventKind::button_up:
        take_pen_button(device, moment);
        break;
      case PenEventKind::stroke_begin:
        if (barrel_ || pen_view_) break;
        if (const ViewHold* held = held_view(); held != nullptr && hits_.on_canvas(at_)) {
          touch_view_ = *held;
          drag_ = at_;
          drag_moved_ = false;
          break;
        }
        if (workspace_.session().pens().on_canvas()) {
          pen_pressed(at_);
        } else {
          mouse_on_panel_ = true;
          hover_panels(at_, true);
        }
        break;
      case PenEventKind::stroke_point:
        if (barrel_) {
          drag_to(at_, true, false);
        } else if (const auto& view = pen_view_ ? pen_view_ : touch_view_) {
          drag_to(at_, *view == ViewHold::move, *view == ViewHold::zoom);
        } else if (mouse_on_panel_) {
          hover_panels(at_, true);
        } else {
          pen_moved(at_);
        }
        break;
      case PenEventKind::stroke_end:
        if (std::exchange(touch_view_, std::nullopt)) {
          drag_.reset();
          place_pen();
        } else if (mouse_on_panel_) {
          hover_panels(at_, false);
        } else {
          pen_released(at_);
        }
        mouse_on_panel_ = false;
        break;
      case PenEventKind::away:
        barrel_ = false;
        pen_view_.reset();
        drag_.reset();
        desk_.pen_left(device);
        break;
      default:
        break;
    }
  }
}

void App::mouse_moved(PxPoint at) {
  if (tablet_is_near()) return;
  at_ = at;
  if (drag_ && !touch_view_) {
    drag_to(at, drag_pans_, drag_zooms_);
  } else if (mouse_draws_) {
    take_moments(0, workspace_.pen({at, k_mouse_pressure, true, true, false, false}));
  } else if (mouse_on_panel_) {
    try_pen(at, k_mouse_pressure, false);
    hover_panels(at, true);
  } else {
    hover(at);
  }
}

void App::mouse_button(MouseButton button, bool down, PxPoint at, bool shift, bool ctrl) {
  // Releases are taken even then, so that nothing stays held.
  if (down && tablet_is_near()) return;
  at_ = at;
  if (button != MouseButton::left) {
    if (down && !mouse_draws_ && !mouse_on_panel_ && hits_.on_canvas(at)) {
      drag_pans_ = shift;
      drag_zooms_ = ctrl;
      barrel_ = button == MouseButton::right;
      begin_drag(at);
    } else if (!down && drag_) {
      if (barrel_) {
        end_barrel(at);
      } else {
        drag_.reset();
      }
      drag_pans_ = drag_zooms_ = false;
    }
    return;
  }
  if (down) {
    if (mouse_draws_ || mouse_on_panel_ || drag_) return;
    if (!hits_.on_canvas(at) || (player_ && player_->playing())) {
      mouse_on_panel_ = true;
      try_pen(at, k_mouse_pressure, true);
      hover_panels(at, true);
      return;
    }
    // Sent away from any widget, so that an open text field ends.
    hover_panels(at, true);
    hover_panels(at, false);
    commit_view();
    workspace_.place_pen(held_view() == nullptr);
    whole_ = shift || ctrl;
    mouse_draws_ = true;
    take_moments(0, workspace_.pen({at, k_mouse_pressure, true, true, false, false}));
  } else if (mouse_draws_) {
    mouse_draws_ = false;
    whole_ = false;
    take_moments(0, workspace_.pen({at, 0, true, false, false, false}));
  } else if (mouse_on_panel_) {
    mouse_on_panel_ = false;
    hover_panels(at, false);
  }
}

void App::wheel(double steps) {
  // The desktop turns two fingers on a tablet into a wheel.
  if (fingers_move_view()) return;
  if (!hits_.on_canvas(at_)) {
    panel_wheel_ += steps;
    return;
  }
  if (pen_is_drawing()) return;
  framed_ = false;
  view_.camera = zoomed(view_, std::pow(k_zoom_per_notch, std::clamp(steps, -20.0, 20.0)), at_, surface_.size());
}

void App::finger(FingerKind kind, std::int64_t finger, PxPoint at) {
  if (tablet_is_near()) return;
  using Kind = TouchAct::Kind;
  for (const TouchAct& act : touch_.add(kind, finger, at)) {
    switch (act.kind) {
      case Kind::pen_down:
        mouse_button(MouseButton::left, true, act.at);
        break;
      case Kind::pen_move:
        mouse_moved(act.at);
        break;
      case Kind::pen_up:
        mouse_button(MouseButton::left, false, act.at);
        break;
      case Kind::orbit:
      case Kind::pan:
      case Kind::zoom:
        // The same fingers may come from the tablet itself, too.
        if (!fingers_move_view()) do_gesture(act);
        break;
    }
  }
}

void App::do_gesture(const TouchAct& act) {
  if (pen_is_drawing() || panels_.dialog != Dialog::none) return;
  framed_ = false;
  if (act.kind == TouchAct::Kind::orbit) {
    view_.camera = orbited(view_.camera, -act.by.x * k_degrees_per_px / scale(), act.by.y * k_degrees_per_px / scale());
  } else if (act.kind == TouchAct::Kind::pan) {
    view_.camera = panned(view_, act.by);
  } else {
    view_.camera = zoomed(view_, std::clamp(act.factor, 0.2, 5.0), act.at, surface_.size());
  }
}

void App::key(const KeyStroke& key) {
  const ActionInfo* action = action_of(key);
  if (action != nullptr) do_action(action->action);
}

}  // namespace penpose::app
