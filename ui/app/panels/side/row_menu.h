#pragma once

#include <span>
#include <string>
#include <vector>

#include "ui/app/controls/controls.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panels.h"

// What can be done with a row of the list of controls, or with a group of rows, besides moving them.

namespace penpose::app {

/// Controls by name, of one row or of a group.
using ControlNames = std::vector<std::string>;

/// What the menus work with.
struct RowOwners {
  EditingSession& editing;
  Controls& controls;
  Dialogs& dialogs;
};

[[nodiscard]] bool is_locked(const EditingSession& editing, const std::string& name);
[[nodiscard]] bool all_locked(const EditingSession& editing, const ControlNames& names);
/// Sketched controls have a line that can be drawn again.
[[nodiscard]] bool is_sketched(const EditingSession& editing, const std::string& name);
/// These controls alone are free: all others are locked.
[[nodiscard]] bool only_free(const EditingSession& editing, const ControlNames& names);
/// Locks all others and frees these; frees all others again where that is so already.
void free_alone(EditingSession& editing, const ControlNames& names);

/// Asks for the menu of the last item where it was touched, or pressed for long. `pressed`: it was touched.
void ask_for_menu(PanelContext& context, const char* name, bool pressed);
/// The menu of a row, while it is open: of one control, or of the left and the right one of a pair. `group`: all of the
/// group that it is listed in; empty: in none.
void show_row_menu(PanelContext& context, const RowOwners& with, const ControlNames& row, const ControlNames& group);
/// The menu of a group.
void show_group_menu(PanelContext& context, const RowOwners& with, const ControlNames& group);

/// Buttons over the right end of a row's or a group's name, while the pointer hovers there: locked or free, drawn
/// again, back to rest. `label`: what their names end in. Px that they take.
[[nodiscard]] float quick_buttons_width(const PanelContext& context, const RowOwners& with, const ControlNames& names);
void show_quick_buttons(PanelContext& context, const RowOwners& with, const ControlNames& names,
                        const std::string& label);

}  // namespace penpose::app
