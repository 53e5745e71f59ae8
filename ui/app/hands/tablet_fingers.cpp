#include "ui/app/hands/tablet_fingers.h"

#include <algorithm>

namespace penpose::app {
namespace {

/// So long the desktop's own idea of the same fingers is ignored.
constexpr std::int64_t k_quiet_us = 250'000;

}  // namespace

bool TabletFingers::move_view() const { return moved_us_ >= 0 && parts_.clock() - moved_us_ < k_quiet_us; }

PxPoint TabletFingers::place_of(int device, const decode::TouchContact& contact) const {
  const decode::TouchAxes& axes = parts_.editing.session().hands().touch(device)->axes();
  const auto share = [](const decode::Axis& axis, std::int32_t at) {
    const double range = static_cast<double>(axis.maximum) - axis.minimum;
    return range > 0 ? (static_cast<double>(at) - axis.minimum) / range : 0.0;
  };
  double x = share(axes.x, contact.x);
  double y = share(axes.y, contact.y);
  if (parts_.preferences.settings().tablet.left_handed) {
    x = 1 - x;
    y = 1 - y;
  }
  const geometry::Viewport window = parts_.canvas.window();
  const double width = window.width;
  // As far in both directions for the same way of the fingers, whatever shape the window has.
  const double across = (axes.x.maximum - axes.x.minimum) / std::max(axes.x.units_per_mm, 1e-9);
  const double down = (axes.y.maximum - axes.y.minimum) / std::max(axes.y.units_per_mm, 1e-9);
  const bool known = axes.x.units_per_mm > 0 && axes.y.units_per_mm > 0;
  return {x * width, y * (known ? width * down / across : static_cast<double>(window.height))};
}

void TabletFingers::take(int device) {
  const replay::HandInput& hands = parts_.editing.session().hands();
  if (hands.touch(device) == nullptr) return;
  TouchGestures& gestures = gestures_.try_emplace(device, TouchGestures(4 * parts_.canvas.scale())).first->second;
  for (const auto& finger : parts_.desk.fingers_changed(device, hands.fingers(device))) {
    for (const TouchAct& act : gestures.add(finger.kind, finger.id, place_of(device, finger.contact))) {
      using Act = TouchAct::Kind;
      // One finger is the desktop's: on a tablet it moves the pointer, on a display it draws.
      if (act.kind == Act::pen_down || act.kind == Act::pen_move || act.kind == Act::pen_up) continue;
      moved_us_ = parts_.clock();
      parts_.drag.do_gesture(act);
    }
  }
}

}  // namespace penpose::app
