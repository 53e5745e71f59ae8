#pragma once

#include <optional>
#include <span>

#include "replay/session/pen_input.h"
#include "ui/app/canvas/curves_in_hand.h"
#include "ui/app/hands/dials.h"
#include "ui/app/hands/held_keys.h"
#include "ui/app/input/panel_input.h"
#include "ui/app/input/view_drag.h"
#include "ui/app/panels/panel_state.h"

namespace penpose::app {

/// What pens do, and the mouse where it is one: they draw, press panels, turn the view and open the menu around them.
class Pens {
 public:
  struct Parts {
    EditingSession& editing;
    const HitMap& hits;
    Dialogs& dialogs;
    PanelState& panels;
    HandDesk& desk;
    Bindings& bindings;
    PointerPlace& place;
    PanelInput& panel_input;
    ViewDrag& drag;
    Dials& dials;
    HeldKeys& keys;
    CurvesInHand& curves;
  };
  explicit Pens(const Parts& parts) : parts_(parts) {}

  void take(int device, std::span<const replay::PenMoment> moments);
  /// The pointer moves and nothing is pressed.
  void hover(PxPoint at);

  /// A panel is pressed, and the presser stays on it until it lifts.
  void press_panel(PxPoint at);
  void lift_from_panel(PxPoint at);
  [[nodiscard]] bool on_panel() const { return on_panel_; }

  /// The pen's button, or the mouse's right one, turns the view; a click of it opens the menu around the pen.
  void begin_menu_drag(PxPoint at);
  void end_menu_drag(PxPoint at);
  /// No menu opens any more, however the drag ends.
  void end_menu() { menu_drag_ = false; }
  [[nodiscard]] bool menu_drag() const { return menu_drag_; }
  /// The pen's tip moves the view, because a key is held.
  [[nodiscard]] bool tip_moves_view() const { return tip_view_.has_value(); }

  /// A tablet is gone: its pen presses nothing any more.
  void tablet_left();
  /// An interface of a tablet is gone.
  void button_gone() { button_view_.reset(); }
  /// Another document is opened.
  void forget();

 private:
  void take_moment(int device, const replay::PenMoment& moment);
  void take_button(int device, const replay::PenMoment& moment);
  void turn_dials(int device, const replay::PenMoment& moment);
  void begin_stroke(PxPoint at);
  void go_on(PxPoint at);
  void end_stroke(PxPoint at);

  Parts parts_;
  bool on_panel_ = false;
  bool menu_drag_ = false;
  std::optional<ViewHold> button_view_;  ///< a button of the pen moves the view
  std::optional<ViewHold> tip_view_;     ///< the pen's tip does, while a key is held
};

}  // namespace penpose::app
