#pragma once

#include <vector>

#include "ui/app/view/area.h"

namespace penpose::app {

/// Which places of the window belong to panels, as of the last frame. What begins on a panel never draws.
struct HitMap {
  std::vector<Area> panels;
  bool all = false;  ///< a dialog or a menu is open: nothing else is to be hit

  [[nodiscard]] bool on_canvas(PxPoint p) const {
    if (all) return false;
    for (const Area& panel : panels) {
      if (panel.holds(p)) return false;
    }
    return true;
  }
};

}  // namespace penpose::app
