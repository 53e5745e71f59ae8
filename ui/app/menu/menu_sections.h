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

/// The menu: every action, each in one section. What menu_sections.cpp does not place stands at the end of a section:
/// tools of Edit, what is of time of Animation, all else of View.
[[nodiscard]] const std::vector<MenuSection>& menu_sections();

/// The section in which an action is. Precondition: it is in the list of actions.
[[nodiscard]] const MenuSection& section_of(Action action);

}  // namespace penpose::app
