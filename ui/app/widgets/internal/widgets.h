#pragma once

#include <functional>
#include <imgui.h>
#include <string>
#include <string_view>

#include "ui/app/panels/panels.h"
#include "ui/app/widgets/button_weight.h"

// Widgets that are large enough for a pen and note where they are. Private to the module: ImGui's types show.

namespace penpose::app {

/// Notes the last item under its label.
void note(PanelContext& context, const char* label);
/// An ordinary button that is at least one unit high; width 0: as wide as its text and a unit, -1: what is left.
bool wide_button(PanelContext& context, const char* label, float width = 0, bool chosen = false,
                 const char* tip = nullptr);
struct ButtonLook {
  float width = 0;  ///< 0: as wide as what is on it, -1: what is left
  bool chosen = false;
  const char* tip = nullptr;
  std::string_view icon = {};  ///< icon.h
  bool text = true;            ///< its label is shown; else the icon alone
  bool left_aligned = false;
  std::string_view key = {};  ///< its key, at the right
  ButtonWeight weight = ButtonWeight::ordinary;
  bool lit = false;  ///< what it stands for is pressed now, elsewhere
};
/// A button with an icon, as high as others.
bool icon_button(PanelContext& context, const char* label, const ButtonLook& look);
/// The one thing to do now, of a panel or a dialog.
bool primary_button(PanelContext& context, const char* label, float width = 0, const char* tip = nullptr);
/// A quiet button with an icon alone, one unit square.
bool quiet_icon(PanelContext& context, const char* label, std::string_view icon, const char* tip, bool chosen = false);
/// How wide it is where its width is 0.
[[nodiscard]] float button_width(const PanelContext& context, const char* label, std::string_view icon, bool text);
/// How wide a column of a menu is: two of them lie beside each other in any window.
[[nodiscard]] float menu_column(const PanelContext& context);
/// An entry of a menu: an icon, a text at the left, its key at the right where there is room for both.
bool menu_entry(PanelContext& context, const char* label, std::string_view icon, std::string_view key, const char* tip);
/// A text as far as it fits, with an ellipsis where it does not.
[[nodiscard]] std::string fitted_text(std::string_view text, float width);
/// The same of a control's name, whose side stays to be told: "outer brow ra… L".
[[nodiscard]] std::string fitted_name(std::string_view name, float width);
/// A line of text in a place of its own, no wider than that.
void text_line(PanelContext& context, std::string_view text, float width, ImU32 color);

/// A quiet button with a padlock on it, closed or open.
bool lock_button(PanelContext& context, const char* label, bool locked, const char* tip);
/// A button of an action with its tooltip; does it when pressed.
bool action_button(PanelContext& context, Action action, float width = 0, bool chosen = false,
                   const char* label = nullptr, ButtonWeight weight = ButtonWeight::ordinary);
/// A quiet button of an action in a toolbar: its word beside its icon, or the icon alone.
bool tool_button(PanelContext& context, Action action, float width, bool words, bool chosen = false,
                 ButtonWeight weight = ButtonWeight::quiet, const char* label = nullptr);
/// Says what the last item is for, once the pointer has rested on it, where it covers no neighbour.
void tooltip(PanelContext& context, const char* text);
/// A line of text in the middle of a row of buttons.
void text_beside(PanelContext& context, const char* text);
/// A window without any decoration in a place of its own, part of the hit map.
bool begin_panel(PanelContext& context, const char* name, const Area& area, bool scrolls = false);
void end_panel();
/// What is in the current window is scrolled by dragging it, too, where it has not all room.
void scrolls_by_drag(PanelContext& context);
/// What is pressed in the current window waits until it is let go or moves to the side, as where something scrolls: a
/// press that rests may then ask for a menu.
void holds_presses(PanelContext& context);
/// A list that scrolls; `ImGui::EndChild` behind it. `size` as ImGui::BeginChild has it.
void begin_list(PanelContext& context, const char* name, const ImVec2& size, bool border = false);
/// A dialog in the middle of the window.
bool begin_dialog(PanelContext& context, const char* title, float width_units);
void end_dialog();
/// A slider as high as a target, with a name and its value on it; true while it is moved, `released` when it is let go.
bool tall_slider(PanelContext& context, const char* id, double& value, double least, double most, float width,
                 const std::string& name, bool& released);
struct SliderLook {
  float width = 0;
  std::string name;   ///< under which it is found: "slider NAME"
  std::string shown;  ///< what stands on it
  double rest = 0;    ///< from where it is filled
  bool locked = false;
  bool numbered = true;  ///< shows its value, which `shown` may say in other words
  bool shy = false;      ///< shows it under the pointer and while it changes alone
  bool changes = false;  ///< it does
};
/// The same with more to say; one that is locked does not move.
bool control_slider(PanelContext& context, const char* id, double& value, double least, double most,
                    const SliderLook& look, bool& released);
/// Pictures side by side in a list.
struct PictureRow {
  int across = 1;   ///< pictures in a row
  float width = 0;  ///< of each, px
};
/// Rows in the list that was begun: as few pictures each as leave them no wider than `widest` px and the first row,
/// with the line under it, no higher than `height`. The list's scroll bar has its room whether it shows or not, so that
/// there is one layout.
PictureRow picture_row(const PanelContext& context, float widest, float height);
/// A text field of one line. `accepted`: Return was pressed in it.
bool text_field(PanelContext& context, const char* label, std::string& text, float width = -1, const char* hint = "",
                bool* accepted = nullptr);
/// Notes a text field that was just shown, and whether it is typed into.
void note_field(PanelContext& context, const char* label);
/// What a text becomes where Tab is pressed in it.
using TextCompleter = std::function<std::string(const std::string& text)>;
/// The text field of a dialog, which takes the keyboard as soon as there is one.
void dialog_field(PanelContext& context, const char* label, std::string& text, const char* hint,
                  const TextCompleter* complete = nullptr);
/// A menu that was opened by its name; nothing else is hit and Escape closes it. `ImGui::EndPopup` where true.
bool begin_menu(PanelContext& context, const char* name);
/// Tells ImGui which keys edit text.
void map_edit_keys();

}  // namespace penpose::app
