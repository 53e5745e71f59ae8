#include "ui/app/input/pens.h"

#include <utility>

namespace penpose::app {

namespace {

using decode::PenEventKind;
using Kind = Binding::Kind;

}  // namespace

void Pens::hover(PxPoint at) {
  parts_.place.move(at);
  parts_.panel_input.add(at, false);
  parts_.curves.hover(at, parts_.hits.on_canvas(at));
}

void Pens::press_panel(PxPoint at) {
  on_panel_ = true;
  parts_.panel_input.add(at, true);
}

void Pens::lift_from_panel(PxPoint at) {
  if (std::exchange(on_panel_, false)) parts_.panel_input.add(at, false);
}

void Pens::begin_menu_drag(PxPoint at) {
  menu_drag_ = true;
  parts_.drag.begin(at);
}

void Pens::end_menu_drag(PxPoint at) {
  const bool clicked = parts_.drag.clicked();
  parts_.drag.end();
  menu_drag_ = false;
  if (clicked && parts_.dialogs.open() == Dialog::none) parts_.panels.radial = at;
}

void Pens::tablet_left() {
  menu_drag_ = false;
  parts_.drag.end();
  tip_view_.reset();
  lift_from_panel(parts_.place.at());
}

void Pens::forget() {
  tip_view_.reset();
  button_view_.reset();
}

void Pens::take(int device, std::span<const replay::PenMoment> moments) {
  for (const replay::PenMoment& moment : moments) {
    parts_.place.move(moment.position);
    turn_dials(device, moment);
    take_moment(device, moment);
  }
}

void Pens::take_moment(int device, const replay::PenMoment& moment) {
  const PxPoint at = moment.position;
  switch (moment.kind) {
    case PenEventKind::hover:
      if (menu_drag_) {
        parts_.drag.drag_to(at, ViewHold::turn);
      } else if (button_view_) {
        parts_.drag.drag_to(at, *button_view_);
      } else {
        hover(at);
      }
      parts_.keys.place_pen();
      break;
    case PenEventKind::button_down:
    case PenEventKind::button_up:
      take_button(device, moment);
      break;
    case PenEventKind::stroke_begin:
      begin_stroke(at);
      break;
    case PenEventKind::stroke_point:
      go_on(at);
      break;
    case PenEventKind::stroke_end:
      end_stroke(at);
      break;
    case PenEventKind::away:
      menu_drag_ = false;
      button_view_.reset();
      parts_.drag.end();
      parts_.desk.pen_left(device);
      break;
    default:
      break;
  }
}

void Pens::begin_stroke(PxPoint at) {
  if (menu_drag_ || button_view_) return;
  if (const ViewHold* held = parts_.keys.held_view(); held != nullptr && parts_.hits.on_canvas(at)) {
    tip_view_ = *held;
    parts_.drag.take(at);
  } else if (parts_.editing.session().pens().on_canvas()) {
    parts_.curves.press(at);
  } else {
    press_panel(at);
  }
}

void Pens::go_on(PxPoint at) {
  if (menu_drag_) {
    parts_.drag.drag_to(at, ViewHold::move);
  } else if (const auto& view = button_view_ ? button_view_ : tip_view_) {
    parts_.drag.drag_to(at, *view);
  } else if (on_panel_) {
    parts_.panel_input.add(at, true);
  } else {
    parts_.curves.move(at);
  }
}

void Pens::end_stroke(PxPoint at) {
  if (std::exchange(tip_view_, std::nullopt)) {
    parts_.drag.end();
    parts_.keys.place_pen();
    on_panel_ = false;
  } else if (on_panel_) {
    lift_from_panel(at);
  } else {
    parts_.curves.release(at);
  }
}

void Pens::take_button(int device, const replay::PenMoment& moment) {
  const PxPoint at = moment.position;
  const PadControl control = pen_button_control(moment.button);
  DeskTablet* tablet = parts_.desk.find(device);
  const Binding binding = tablet != nullptr ? parts_.bindings.bound(*tablet, control) : default_binding(control, {});
  const bool free = parts_.hits.on_canvas(at) && !parts_.editing.pen_is_drawing() && !menu_drag_ && !button_view_;
  if (moment.kind == PenEventKind::button_down) {
    const bool chooses = parts_.dialogs.open() == Dialog::pad;
    if (!chooses && binding.kind == Kind::pen_menu && free) {
      begin_menu_drag(at);
    } else if (!chooses && binding.kind == Kind::view && free) {
      button_view_ = binding.view;
      parts_.drag.begin(at);
    } else if (tablet != nullptr && (chooses || binding.kind != Kind::view)) {
      parts_.keys.press(*tablet, device, control);
    }
    return;
  }
  if (binding.kind == Kind::pen_menu && menu_drag_) end_menu_drag(at);
  if (binding.kind == Kind::view && std::exchange(button_view_, std::nullopt)) parts_.drag.end();
  parts_.keys.let_go(device, control);
}

void Pens::turn_dials(int device, const replay::PenMoment& moment) {
  DeskTablet* tablet = parts_.desk.find(device);
  const decode::PenAxes* axes = parts_.editing.session().pens().axes_of(device);
  if (tablet == nullptr || axes == nullptr || moment.kind == PenEventKind::away) return;
  for (const bool rotation : {false, true}) {
    const PadControl control{rotation ? PadControl::Kind::pen_rotation : PadControl::Kind::pen_wheel, 0, 0};
    const decode::Axis& axis = rotation ? axes->rotation : axes->wheel;
    const auto steps = parts_.desk.pen_turned(device, rotation, rotation ? moment.rotation : moment.wheel, axis);
    if (steps == 0) continue;
    if (const Binding binding = parts_.bindings.bound(*tablet, control); binding.kind == Kind::dial) {
      parts_.dials.turn(binding.dial, device, control, steps);
    }
  }
}

}  // namespace penpose::app
