#pragma once

#include <string_view>
#include <vector>

#include "ui/app/action.h"

namespace penpose::app {

/// A section of the menu.
struct MenuSection {
  std::string_view name;
  std::string_view icon;                    ///< icon.h
  std::vector<std::vector<Action>> groups;  ///< entries that belong together, from above
};

/// The menu: every action, each in one section, but for the keys of the cameras, which the dialog *Cameras* shows. What
/// menu_sections.cpp does not place stands at the end of a section: tools of Edit, what is of time of Animation, all
/// else of View.
[[nodiscard]] const std::vector<MenuSection>& menu_sections();

}  // namespace penpose::app
