#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "ui/app/view/area.h"

// What panels keep that others look at.

namespace penpose::app {

/// Which parameters are listed.
struct ParameterList {
  std::string filter;
  std::set<std::string> folded;  ///< groups
  bool moved_only = false;       ///< only controls that are not at rest
  /// Those that were listed so. One that is locked stays, though what was drawn is then solved without it.
  std::set<std::string> moved;
};

/// The list of sketched controls.
struct ControlList {
  std::string scrolled_to;  ///< the one that it was last scrolled to
  std::string rename;       ///< what is being typed as a name of the selected control
};

/// The part of time that the timeline shows, seconds.
struct TimelineShown {
  double from_s = 0;
  double span_s = 0;                                  ///< 0: all
  double seen_time_s = 0;                             ///< where the cursor was last brought into sight
  std::optional<std::pair<double, double>> key_drag;  ///< a key in hand: from, to
  std::string frame_text;                             ///< what is being typed as a frame
};

/// The row of other readings.
struct ReadingsPlace {
  std::optional<Area> area;          ///< nothing: none are offered
  std::optional<std::size_t> taken;  ///< the button that the pen pressed and is still over
};

}  // namespace penpose::app
