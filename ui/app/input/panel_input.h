#pragma once

#include <deque>
#include <utility>

#include "core/geometry/space.h"

namespace penpose::app {

using geometry::PxPoint;

/// Where the pointer is for the panels.
struct PanelPointer {
  PxPoint at;
  bool down = false;
};

/// What waits for the panels of the next frames: the pointer's places in their order, and turns of the wheel.
class PanelInput {
 public:
  void add(PxPoint at, bool down) {
    // Moves in between tell nothing; presses and releases must not be lost between two frames.
    if (pointer_.size() > 1 && pointer_.back().down == down && pointer_[pointer_.size() - 2].down == down) {
      pointer_.back().at = at;
      return;
    }
    pointer_.push_back({at, down});
  }
  /// Another button than the left was pressed over the panels: what is below it shows its menu.
  void ask_menu() { menu_asked_ = true; }
  [[nodiscard]] bool take_menu_asked() { return std::exchange(menu_asked_, false); }
  void add_wheel(double steps) { wheel_ += steps; }

  [[nodiscard]] std::deque<PanelPointer>& pointer() { return pointer_; }
  [[nodiscard]] double take_wheel() { return std::exchange(wheel_, 0.0); }

 private:
  std::deque<PanelPointer> pointer_;
  double wheel_ = 0;
  bool menu_asked_ = false;
};

}  // namespace penpose::app
