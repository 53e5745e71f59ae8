#pragma once

#include <cstdint>

#include "ui/app/files/player.h"
#include "ui/app/hands/tablet_fingers.h"
#include "ui/app/input/pens.h"

namespace penpose::app {

enum class MouseButton : std::uint8_t { left, middle, right };

/// Mouse, wheel and fingers on the screen, in px of the window. The desktop's pointer is silent while a pen is near.
class Pointer {
 public:
  struct Parts {
    EditingSession& editing;
    Canvas& canvas;
    const HitMap& hits;
    Dialogs& dialogs;
    const Player& player;
    PointerPlace& place;
    PanelInput& panel_input;
    ViewDrag& drag;
    const TabletFingers& tablet_fingers;
    const HeldKeys& keys;
    CurvesInHand& curves;
    Pens& pens;
  };
  explicit Pointer(const Parts& parts);

  /// The window's size, which it says before every frame.
  void resized(geometry::Viewport window, double dpi, double own_scale = 0);
  void moved(PxPoint at);
  void button(MouseButton button, bool down, PxPoint at, bool shift = false, bool ctrl = false);
  void wheel(double steps);
  void finger(FingerKind kind, std::int64_t finger, PxPoint at);
  /// It has left the window.
  void left();

 private:
  void drag_button(MouseButton button, bool down, PxPoint at, ViewHold how);
  void press(PxPoint at, bool whole);
  void lift(PxPoint at);

  Parts parts_;
  TouchGestures touch_;
  bool draws_ = false;              ///< the left button is held on the canvas
  ViewHold drag_ = ViewHold::turn;  ///< what another button does
};

}  // namespace penpose::app
