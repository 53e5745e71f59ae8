#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/app/app.h"

// The pieces of the interface. Called between ImGui's NewFrame and Render alone.

namespace penpose::app {

class PosePictures;

/// What every piece works with.
struct PanelContext {
  App& app;
  std::map<std::string, Area, std::less<>>& targets;
  PosePictures& pictures;
  float unit = 34;  ///< px of a target that a pen hits for certain
  float gap = 6;
  std::optional<Area> typed_into = {};   ///< the text field that has the keyboard
  std::vector<Area> fields = {};         ///< all that can be typed into
  bool accepts = false;                  ///< Return was pressed: the dialog does what it is for
  bool cancels = false;                  ///< Escape was pressed: the dialog, or else the menu, closes
  bool field_first = false;              ///< the dialog's field takes the keyboard
  bool has_field = false;                ///< the dialog has one
  bool dialog_opens = false;             ///< it is in its first frame
  bool menu_open = false;                ///< a menu is
  std::optional<Area> dialog_area = {};  ///< where the dialog is
  bool tip_due = false;                  ///< the pointer has rested long enough for a tooltip
  bool tip_waits = false;                ///< it rests on something that has one
};

void show_toolbar(PanelContext& context, const Area& area);
void show_top_bar(PanelContext& context, const Area& area);
void show_side_panel(PanelContext& context, const Area& area);
void show_parameters(PanelContext& context);
void show_deformers(PanelContext& context);
/// What came of the last stroke, and what colours mean.
void show_status(PanelContext& context, const Area& area);
void show_timeline(PanelContext& context, const Area& area);
/// Poses that are keyed, to be taken again.
void show_poses(PanelContext& context);
/// The model's axes in a corner of the canvas.
void show_axes(PanelContext& context, const Area& free);
/// The picture behind the model, and its handling.
void show_backdrop(PanelContext& context, const Area& free);
void show_player(PanelContext& context, const Area& area);
void show_radial_menu(PanelContext& context);
void show_notices(PanelContext& context);
/// Asks for the rest of the face; grey, and saying why, while there are too few keys.
void show_suggest_button(PanelContext& context);
/// What is suggested, to be taken or dismissed.
void show_suggestion(PanelContext& context);
/// What can be done with a curve that was touched, beside it.
void show_curve_menu(PanelContext& context);
/// The dialog that is open (dialog_list.cpp).
void show_dialog(PanelContext& context);

}  // namespace penpose::app
