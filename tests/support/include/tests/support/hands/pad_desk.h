#pragma once

#include <string>
#include <vector>

#include "replay/session/virtual_pen.h"
#include "tests/support/app_desk.h"
#include "tests/support/hands/wacom_hand.h"

namespace penpose::app {

inline constexpr int k_pad = 1;
inline constexpr int k_pen = 2;

/// A desk with an Intuos Pro for the left hand and a pen for the right one.
class PadDesk : public Desk {
 public:
  explicit PadDesk(const std::string& name, bool fresh = true) : Desk(name, "builtin:demo", fresh) {
    begin();
    app->of<TabletEvents>().arrived(k_pad, tests::intuos_pro());
    auto pen = replay::virtual_pen_identity();
    pen.vendor = 0x1b96;
    pen.bus = decode::k_bus_usb;
    pen.name = "Pen display";
    app->of<TabletEvents>().arrived(k_pen, pen);
    frames();
  }
  void hold(unsigned keys, int ring = -1) {
    now_us += 5000;
    app->of<TabletEvents>().report(k_pad, now_us, tests::pad_report(keys, ring));
    frames(2);
  }
  void tap(unsigned key) {
    hold(1U << key);
    hold(0);
  }
  /// A finger that goes over the ring from place to place, and leaves it.
  void ring(int from, int to, bool lift = true) {
    hold(0, from);
    for (int at = from; at != to; at += to > from ? 1 : -1) hold(0, ((at + (to > from ? 1 : -1)) % 72 + 72) % 72);
    if (lift) hold(0);
  }
  void pen(PxPoint at, bool tip, bool barrel = false, bool near = true) {
    now_us += 3000;
    const auto viewport = app->of<EditingSession>().editor().view().viewport;
    app->of<TabletEvents>().report(k_pen, now_us,
                                   replay::virtual_pen_report({at, 0.5, near, tip, false, barrel}, viewport));
    app->begin_frame();
  }
  void draw(const std::vector<PxPoint>& line, bool lift = true) {
    pen(line.front(), false);
    for (const PxPoint& at : line) pen(at, true);
    if (lift) pen(line.back(), false);
  }
  void bind(const PadControl& control, const Binding& binding) {
    app->of<Bindings>().bind(*app->of<HandDesk>().find(k_pad), control, binding);
  }
  [[nodiscard]] drawing::ToolKind tool() const { return app->of<EditingSession>().editor().tool().kind; }
  [[nodiscard]] bool told(const std::string& text) const {
    for (const Notice& one : app->of<Notices>().all()) {
      if (one.text == text) return true;
    }
    return false;
  }
};

inline PadControl key(unsigned number) { return key_control(decode::numbered_key(number)); }

}  // namespace penpose::app
