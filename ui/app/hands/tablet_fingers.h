#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "ui/app/hands/hand_desk.h"
#include "ui/app/input/view_drag.h"
#include "ui/app/preferences.h"

namespace penpose::app {

/// Fingers on tablets, of which two or more move the view.
class TabletFingers {
 public:
  struct Parts {
    std::function<std::int64_t()> clock;
    EditingSession& editing;
    const Preferences& preferences;
    const Canvas& canvas;
    HandDesk& desk;
    ViewDrag& drag;
  };
  explicit TabletFingers(Parts parts) : parts_(std::move(parts)) {}

  /// Looks at the fingers of an interface after a report.
  void take(int device);
  void forget(int device) { gestures_.erase(device); }
  /// Whether they have just moved the view: the desktop may have its own idea of the same fingers.
  [[nodiscard]] bool move_view() const;

 private:
  [[nodiscard]] PxPoint place_of(int device, const decode::TouchContact& contact) const;

  Parts parts_;
  std::map<int, TouchGestures> gestures_;  ///< by interface
  std::int64_t moved_us_ = -1;
};

}  // namespace penpose::app
