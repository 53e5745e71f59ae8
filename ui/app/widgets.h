#pragma once

#include <imgui.h>
#include <string>

#include "ui/app/panels.h"

// Widgets that are large enough for a pen and note where they are. Private to the module: ImGui's types show.

namespace penpose::app {

/// Notes the last item under its label.
void note(PanelContext& context, const char* label);
/// A button that is at least one unit high; width 0: as wide as its text and a unit, -1: what is left.
bool wide_button(PanelContext& context, const char* label, float width = 0, bool chosen = false,
                 const char* tip = nullptr);
/// A button with a padlock on it, closed or open.
bool lock_button(PanelContext& context, const char* label, bool locked, const char* tip);
/// A button of an action with its tooltip; does it when pressed.
bool action_button(PanelContext& context, Action action, float width = 0, bool chosen = false,
                   const char* label = nullptr);
void tooltip(const char* text);
/// A line of text in the middle of a row of buttons.
void text_beside(PanelContext& context, const char* text);
/// A window without any decoration in a place of its own, part of the hit map.
bool begin_panel(PanelContext& context, const char* name, const Area& area, bool scrolls = false);
void end_panel();
/// A dialog in the middle of the window.
bool begin_dialog(PanelContext& context, const char* title, float width_units);
void end_dialog();
/// A slider as high as a target, with a name in it; true while it is moved, `released` when it is let go.
bool tall_slider(PanelContext& context, const char* id, double& value, double least, double most, float width,
                 const std::string& name, bool& released);
/// A text field of one line. `accepted`: Return was pressed in it.
bool text_field(PanelContext& context, const char* label, std::string& text, float width = -1, const char* hint = "",
                bool* accepted = nullptr);
/// Notes a text field that was just shown, and whether it is typed into.
void note_field(PanelContext& context, const char* label);
/// The text field of a dialog, which takes the keyboard as soon as there is one.
void dialog_field(PanelContext& context, const char* label, std::string& text, const char* hint);
/// A menu that was opened by its name; nothing else is hit and Escape closes it. `ImGui::EndPopup` where true.
bool begin_menu(PanelContext& context, const char* name);
/// Tells ImGui which keys edit text.
void map_edit_keys();

}  // namespace penpose::app
