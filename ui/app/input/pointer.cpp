#include "ui/app/input/pointer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app/dialogs/entries.h"

namespace penpose::app {
namespace {

constexpr double k_zoom_per_notch = 0.9;
/// A mouse and a finger press neither hard nor softly.
constexpr double k_pressure = 0.5;
/// So far a finger moves before it draws, of an ordinary display.
constexpr double k_slack_px = 4;

}  // namespace

Pointer::Pointer(const Parts& parts) : parts_(parts), touch_(k_slack_px * parts.canvas.scale()) {}

void Pointer::resized(geometry::Viewport window, double dpi, double own_scale) {
  const std::pair before(parts_.canvas.window(), parts_.canvas.scale());
  parts_.canvas.resized(window, dpi, own_scale);
  // Fingers may be down from one frame to the next.
  if (before != std::pair(parts_.canvas.window(), parts_.canvas.scale()))
    touch_ = TouchGestures(k_slack_px * parts_.canvas.scale());
}

void Pointer::left() { parts_.panel_input.add({-1e4, -1e4}, false); }

void Pointer::moved(PxPoint at) {
  if (parts_.place.tablet_is_near()) return;
  parts_.place.move(at);
  if (parts_.drag.active() && !parts_.pens.tip_moves_view()) {
    parts_.drag.drag_to(at, drag_);
  } else if (draws_) {
    parts_.pens.take(0, parts_.editing.input().pen({at, k_pressure, true, true, false, false}));
  } else if (parts_.pens.on_panel()) {
    try_pen(parts_.dialogs, at, k_pressure, false);
    parts_.panel_input.add(at, true);
  } else {
    parts_.pens.hover(at);
  }
}

void Pointer::button(MouseButton button, bool down, PxPoint at, bool shift, bool ctrl) {
  // Releases are taken even then, so that nothing stays held.
  if (down && parts_.place.tablet_is_near()) return;
  parts_.place.move(at);
  if (button != MouseButton::left) {
    drag_button(button, down, at, ctrl ? ViewHold::zoom : shift ? ViewHold::move : ViewHold::turn);
  } else if (down) {
    press(at, shift || ctrl);
  } else {
    lift(at);
  }
}

void Pointer::drag_button(MouseButton button, bool down, PxPoint at, ViewHold how) {
  if (down && button == MouseButton::right && !parts_.hits.on_canvas(at)) parts_.panel_input.ask_menu();
  if (down && !draws_ && !parts_.pens.on_panel() && parts_.hits.on_canvas(at)) {
    drag_ = how;
    if (button == MouseButton::right) {
      parts_.pens.begin_menu_drag(at);
    } else {
      parts_.pens.end_menu();
      parts_.drag.begin(at);
    }
  } else if (!down && parts_.drag.active()) {
    if (parts_.pens.menu_drag()) {
      parts_.pens.end_menu_drag(at);
    } else {
      parts_.drag.end();
    }
    drag_ = ViewHold::turn;
  }
}

void Pointer::press(PxPoint at, bool whole) {
  if (draws_ || parts_.pens.on_panel() || parts_.drag.active()) return;
  if (!parts_.hits.on_canvas(at) || (parts_.player.trace && parts_.player.trace->playing())) {
    try_pen(parts_.dialogs, at, k_pressure, true);
    parts_.pens.press_panel(at);
    return;
  }
  // Sent away from any widget, so that an open text field ends.
  parts_.panel_input.add(at, true);
  parts_.panel_input.add(at, false);
  parts_.canvas.commit();
  parts_.editing.input().place_pen(parts_.keys.held_view() == nullptr);
  parts_.curves.set_whole(whole);
  draws_ = true;
  parts_.pens.take(0, parts_.editing.input().pen({at, k_pressure, true, true, false, false}));
}

void Pointer::lift(PxPoint at) {
  if (std::exchange(draws_, false)) {
    parts_.curves.set_whole(false);
    parts_.pens.take(0, parts_.editing.input().pen({at, 0, true, false, false, false}));
  } else {
    parts_.pens.lift_from_panel(at);
  }
}

void Pointer::wheel(double steps) {
  // The desktop turns two fingers on a tablet into a wheel.
  if (parts_.tablet_fingers.move_view()) return;
  const PxPoint at = parts_.place.at();
  if (!parts_.hits.on_canvas(at)) {
    parts_.panel_input.add_wheel(steps);
  } else if (!parts_.editing.pen_is_drawing()) {
    parts_.canvas.zoom(std::pow(k_zoom_per_notch, std::clamp(steps, -20.0, 20.0)), at);
  }
}

void Pointer::finger(FingerKind kind, std::int64_t finger, PxPoint at) {
  if (parts_.place.tablet_is_near()) return;
  using Act = TouchAct::Kind;
  for (const TouchAct& act : touch_.add(kind, finger, at)) {
    switch (act.kind) {
      case Act::pen_down:
        button(MouseButton::left, true, act.at);
        break;
      case Act::pen_move:
        moved(act.at);
        break;
      case Act::pen_up:
        button(MouseButton::left, false, act.at);
        break;
      case Act::orbit:
      case Act::pan:
      case Act::zoom:
        // The same fingers may come from the tablet itself, too.
        if (!parts_.tablet_fingers.move_view()) parts_.drag.do_gesture(act);
        break;
    }
  }
}

}  // namespace penpose::app
