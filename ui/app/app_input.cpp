#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/articulation/edit.h"
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

void App::resized(geometry::Viewport window, double dpi) {
  const std::pair before(canvas_.window(), canvas_.scale());
  canvas_.resized(window, dpi);
  // The window says its size before every frame, and fingers may be down meanwhile.
  if (before != std::pair(canvas_.window(), canvas_.scale())) touch_ = TouchGestures(4 * canvas_.scale());
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
  if (canvas_.hits().on_canvas(at) && !editing_.pen_is_drawing() && !editing_.document().curves.empty()) {
    highlighted_ = curve_near(editing_, canvas_.surface(), at, 8 * canvas_.scale());
  }
}

void App::pointer_left() { hover_panels({-1e4, -1e4}, false); }

void App::pen_pressed(PxPoint at) {
  if (editing_.editor().tool().kind == drawing::ToolKind::none) select_at(at);
}

void App::hold_line(const std::vector<geometry::ModelPoint>& line, PxPoint at) {
  pull_ = PullHold{at, curve::k_usual_reach};
  const auto camera = geometry::Camera::make(canvas_.view().camera, canvas_.view().viewport);
  std::vector<PxPoint> seen;
  for (const auto& point : line) {
    const auto px = camera ? camera->project(point) : std::nullopt;
    if (px) seen.push_back(*px);
  }
  // Of a short line most would be its middle.
  const double handle = std::min(k_handle_px * canvas_.scale(), k_handle_share * curve::arc_length<PxPoint>(seen));
  const bool at_middle = !seen.empty() && geometry::distance(seen[seen.size() / 2], at) < handle;
  if (whole_ || at_middle) pull_.reset();
}

bool App::take_control_target(PxPoint at) {
  const auto& deformers = editing_.document().model->deformers;
  const auto number =
      deformers && panels_.controls_tab ? articulation::find_deformer(*deformers, controls_.selected()) : std::nullopt;
  const auto camera = geometry::Camera::make(canvas_.view().camera, canvas_.view().viewport);
  if (!number || !camera) return false;
  const articulation::Deformer& deformer = *deformers->deformers()[*number];
  const auto near = [&](std::span<const geometry::ModelPoint> line) {
    std::vector<PxPoint> seen;
    for (const auto& point : line) {
      if (const auto px = camera->project(point)) seen.push_back(*px);
    }
    return document::come_near(seen, std::array<PxPoint, 1>{at}, 10 * canvas_.scale());
  };
  for (std::size_t i = 0; i < deformer.betweens().size(); ++i) {
    if (!near(deformer.betweens()[i])) continue;
    control_drag_.emplace(deformer.sketch().betweens[i].value, at);
    hold_line(deformer.betweens()[i], at);
    return true;
  }
  if (!near(deformer.target())) return false;
  control_drag_.emplace(1.0, at);
  hold_line({deformer.target().begin(), deformer.target().end()}, at);
  return true;
}

std::optional<document::PullBetween> App::control_pull(PxPoint at) const {
  const PxPoint by = at - control_drag_->second;
  if (std::hypot(by.x, by.y) <= k_click_px * canvas_.scale()) return std::nullopt;
  return document::PullBetween{
      controls_.selected(),      control_drag_->first, editing_.editor().view(), control_drag_->second, by,
      pull_ ? pull_->reach : 0.0};
}

void App::select_at(PxPoint at) {
  target_drag_.reset();
  control_drag_.reset();
  editing_.hold_control_target(std::nullopt);
  touched_curve_.reset();
  panels_.curve_menu.reset();
  highlighted_ = curve_near(editing_, canvas_.surface(), at, 10 * canvas_.scale());
  if (highlighted_) {
    const auto* curve = document::find_curve(editing_.document(), *highlighted_);
    if (curve != nullptr && curve->target) {
      target_drag_.emplace(*highlighted_, at);
      hold_line(curve->target->points, at);
    }
    touched_curve_ = *highlighted_;
    return;
  }
  if (take_control_target(at)) return;
  const auto camera = geometry::Camera::make(canvas_.view().camera, canvas_.view().viewport);
  if (!camera) return;
  const auto hit = canvas_.surface().pick(*camera, at);
  const auto& deformers = editing_.document().model->deformers;
  controls_.select({});
  if (!hit || !deformers) return;
  const std::uint32_t vertex = editing_.document().model->mesh->triangles()[hit->triangle][0];
  double best = 0;
  for (const auto& deformer : deformers->deformers()) {
    const auto vertices = deformer->vertices();
    const auto found = std::lower_bound(vertices.begin(), vertices.end(), vertex);
    if (found == vertices.end() || *found != vertex) continue;
    const double weight = deformer->weights()[static_cast<std::size_t>(found - vertices.begin())];
    if (weight <= best) continue;
    best = weight;
    controls_.select(deformer->sketch().name);
    panels_.controls_tab = true;
  }
}

void App::pen_moved(PxPoint at) {
  at_ = at;
  const replay::DrawnStroke* stroke = editing_.session().pens().current();
  const bool sketches = editing_.editor().tool().kind == drawing::ToolKind::articulate;
  // Only a line begins a control; a tap leaves the face as it is.
  if (sketches && !editing_.document().pending && stroke != nullptr && stroke->on_canvas && !stroke->eraser &&
      !drawing::is_tap(stroke->samples, stroke->view.viewport)) {
    controls_.begin();
  }
  if (control_drag_) editing_.hold_control_target(control_pull(at));
  if (!target_drag_) return;
  const PxPoint by = at - target_drag_->second;
  if (std::hypot(by.x, by.y) > k_click_px * canvas_.scale()) editing_.hold_target(target_drag_->first, by, pull_);
}

void App::pen_released(PxPoint at) {
  controls_.show_new();
  if (control_drag_) {
    const auto pull = control_pull(at);
    control_drag_.reset();
    editing_.hold_control_target(std::nullopt);
    if (pull) editing_.perform(*pull);
    return;
  }
  if (performer_.performing()) {
    if (!performer_.end()) notices_.tell("the take moved nothing: nothing is keyed");
    target_drag_.reset();
    editing_.hold_target(std::nullopt);
    touched_curve_.reset();
    return;
  }
  if (target_drag_) {
    const PxPoint by = at - target_drag_->second;
    const auto id = target_drag_->first;
    target_drag_.reset();
    editing_.hold_target(std::nullopt);
    const auto* curve = document::find_curve(editing_.document(), id);
    if (curve != nullptr && std::hypot(by.x, by.y) > k_click_px * canvas_.scale()) {
      editing_.perform(drag_command(*curve, editing_.editor().view(), by, pull_));
      return;
    }
  }
  if (touched_curve_) {
    panels_.curve_menu = {*touched_curve_, at};
    touched_curve_.reset();
  }
}

void App::begin_drag(PxPoint at) {
  if (editing_.pen_is_drawing()) return;
  drag_ = at;
  drag_moved_ = false;
}

void App::drag_to(PxPoint at, bool pan, bool zoom) {
  if (!drag_) return;
  const PxPoint by = at - *drag_;
  if (!drag_moved_ && std::hypot(by.x, by.y) < k_click_px * canvas_.scale()) return;
  drag_moved_ = true;
  drag_ = at;
  if (zoom) {
    canvas_.zoom(std::exp(by.y * k_zoom_per_px / canvas_.scale()),
                 {0.5 * canvas_.view().viewport.width, 0.5 * canvas_.view().viewport.height});
  } else if (pan) {
    canvas_.pan(by);
  } else {
    canvas_.turn(-by.x * k_degrees_per_px / canvas_.scale(), by.y * k_degrees_per_px / canvas_.scale());
  }
}

void App::end_barrel(PxPoint at) {
  const bool clicked = drag_ && !drag_moved_;
  drag_.reset();
  barrel_ = false;
  if (clicked && dialogs_.open() == Dialog::none) panels_.radial = at;
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
        if (const ViewHold* held = held_view(); held != nullptr && canvas_.hits().on_canvas(at_)) {
          touch_view_ = *held;
          drag_ = at_;
          drag_moved_ = false;
          break;
        }
        if (editing_.session().pens().on_canvas()) {
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
    take_moments(0, editing_.pen({at, k_mouse_pressure, true, true, false, false}));
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
    if (down && !mouse_draws_ && !mouse_on_panel_ && canvas_.hits().on_canvas(at)) {
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
    if (!canvas_.hits().on_canvas(at) || (player_.trace && player_.trace->playing())) {
      mouse_on_panel_ = true;
      try_pen(at, k_mouse_pressure, true);
      hover_panels(at, true);
      return;
    }
    // Sent away from any widget, so that an open text field ends.
    hover_panels(at, true);
    hover_panels(at, false);
    canvas_.commit();
    editing_.place_pen(held_view() == nullptr);
    whole_ = shift || ctrl;
    mouse_draws_ = true;
    take_moments(0, editing_.pen({at, k_mouse_pressure, true, true, false, false}));
  } else if (mouse_draws_) {
    mouse_draws_ = false;
    whole_ = false;
    take_moments(0, editing_.pen({at, 0, true, false, false, false}));
  } else if (mouse_on_panel_) {
    mouse_on_panel_ = false;
    hover_panels(at, false);
  }
}

void App::wheel(double steps) {
  // The desktop turns two fingers on a tablet into a wheel.
  if (fingers_move_view()) return;
  if (!canvas_.hits().on_canvas(at_)) {
    panel_wheel_ += steps;
    return;
  }
  if (editing_.pen_is_drawing()) return;
  canvas_.zoom(std::pow(k_zoom_per_notch, std::clamp(steps, -20.0, 20.0)), at_);
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
  if (editing_.pen_is_drawing() || dialogs_.open() != Dialog::none) return;
  if (act.kind == TouchAct::Kind::orbit) {
    canvas_.turn(-act.by.x * k_degrees_per_px / canvas_.scale(), act.by.y * k_degrees_per_px / canvas_.scale());
  } else if (act.kind == TouchAct::Kind::pan) {
    canvas_.pan(act.by);
  } else {
    canvas_.zoom(std::clamp(act.factor, 0.2, 5.0), act.at);
  }
}

}  // namespace penpose::app
