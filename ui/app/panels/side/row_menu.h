#pragma once

#include <span>
#include <string>
#include <vector>

#include "ui/app/controls/controls.h"
#include "ui/app/controls/restriction.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panels.h"

// What can be done with a row of the list of controls, or with a group of rows, besides moving them.

namespace penpose::app {

/// Controls by name, of one row or of a group.
using ControlNames = std::vector<std::string>;

/// A group of the list.
struct RowGroup {
  ControlNames names;  ///< empty: none
  std::string words;   ///< "brows"
};

/// What the menus work with.
struct RowOwners {
  EditingSession& editing;
  Controls& controls;
  Dialogs& dialogs;
  Restriction& restriction;
};

[[nodiscard]] bool is_locked(const EditingSession& editing, const std::string& name);
[[nodiscard]] bool all_locked(const EditingSession& editing, const ControlNames& names);
/// Sketched controls have a line that can be drawn again.
[[nodiscard]] bool is_sketched(const EditingSession& editing, const std::string& name);

/// Asks for the menu of the last item where it was touched, or pressed for long. `pressed`: it was touched.
void ask_for_menu(PanelContext& context, const char* name, bool pressed);
/// The menu of a row, while it is open: of one control, or of the left and the right one of a pair. `group`: the one
/// that it is listed in.
void show_row_menu(PanelContext& context, const RowOwners& with, const ControlNames& row, const RowGroup& group);
/// The menu of a group.
void show_group_menu(PanelContext& context, const RowOwners& with, const RowGroup& group);

/// Buttons over the right end of a row's or a group's name, while the pointer hovers there: locked or free, drawn
/// again, back to rest. Tells if those between two corners of the window are to be shown.
[[nodiscard]] bool offers_quick_buttons(const PanelContext& context, ImVec2 from, ImVec2 to);
/// Px that they take.
[[nodiscard]] float quick_buttons_width(const PanelContext& context, const RowOwners& with, const ControlNames& names);
void show_quick_buttons(PanelContext& context, const RowOwners& with, const ControlNames& names,
                        const std::string& label);

}  // namespace penpose::app
