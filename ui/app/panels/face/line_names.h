#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/app/panels/panels.h"
#include "ui/app/view/area.h"

namespace penpose::app {

/// A line on the canvas and its name.
struct LineName {
  std::vector<document::PxPoint> line;  ///< px of the window, at least one
  std::string text;
  bool known = true;  ///< else it is marked
};

/// Draws the names beside the ends of their lines, away from the middle of them all and one below the other where they
/// would overlap. Gives where each is; nothing: there is no room for it. `touchable`: the pointer lights a name.
std::vector<std::optional<Area>> show_line_names(PanelContext& context, const Area& free,
                                                 const std::vector<LineName>& names, bool touchable, const char* tip);

}  // namespace penpose::app
