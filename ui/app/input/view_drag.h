#pragma once

#include <optional>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/hands/binding.h"
#include "ui/app/input/touch_gestures.h"

namespace penpose::app {

/// The view in hand: dragged by a pen or a mouse, or moved by fingers.
class ViewDrag {
 public:
  ViewDrag(EditingSession& editing, Canvas& canvas, Dialogs& dialogs);

  /// Takes the view in hand, unless a stroke is being drawn.
  void begin(PxPoint at);
  /// The same whatever is being drawn.
  void take(PxPoint at);
  void drag_to(PxPoint at, ViewHold how);
  void end() { at_.reset(); }
  [[nodiscard]] bool active() const { return at_.has_value(); }
  /// Whether it is in hand and was not moved: a click.
  [[nodiscard]] bool clicked() const { return at_ && !moved_; }
  /// Does what fingers mean.
  void do_gesture(const TouchAct& act);

 private:
  EditingSession& editing_;
  Canvas& canvas_;
  Dialogs& dialogs_;
  std::optional<PxPoint> at_;  ///< its last place
  bool moved_ = false;
};

}  // namespace penpose::app
