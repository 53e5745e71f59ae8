#include "ui/app/panels/side/row_menu.h"

#include <algorithm>

#include "ui/app/dialogs/entries.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

constexpr std::string_view k_padlock = "M6 11L18 11L18 20L6 20Z M9 11A12 8 3 180 360L15 11";
constexpr std::string_view k_open_padlock = "M6 11L18 11L18 20L6 20Z M15 11A18 8 3 180 360";
constexpr std::string_view k_only = "C12 12 8D12 12 3.5";
constexpr std::string_view k_not = "C12 12 8M6.5 17.5L17.5 6.5";

/// An entry of the open menu, which closes it.
bool row_entry(PanelContext& context, const std::string& label, std::string_view drawn, const char* tip = nullptr) {
  const bool pressed = menu_entry(context, label.c_str(), drawn, {}, tip);
  if (pressed) ImGui::CloseCurrentPopup();
  return pressed;
}

void lock_entry(PanelContext& context, const RowOwners& with, const ControlNames& names, const std::string& what) {
  const bool locked = all_locked(with.editing, names);
  const std::string label = (locked ? "Unlock " : "Lock ") + what + "##lock " + names.front();
  if (row_entry(context, label, locked ? k_open_padlock : k_padlock,
                locked ? "Strokes and sliders move it again" : "Neither a stroke nor a slider moves it"))
    lock_parameters(with.editing, names, !locked);
}

void type_entry(PanelContext& context, const RowOwners& with, const std::string& name, const char* label) {
  if (!row_entry(context, label + ("##type " + name), icon::k_pencil, "Type its value, or change its range")) return;
  with.dialogs.state<NumberEntry>() = {name, {}, NumberEntry::Field::value};
  with.dialogs.show(Dialog::number);
}

/// Lines and pulls for this group alone, or for all others.
void restrict_entries(PanelContext& context, const RowOwners& with, const RowGroup& group) {
  if (group.names.empty()) return;
  if (with.restriction.is_only(group.names)) {
    if (row_entry(context, "All groups again##group", k_only, "Lines and pulls may move the other groups again"))
      with.restriction.lift();
  } else if (row_entry(context, "Only this group##group", k_only, "Lines and pulls move this group alone")) {
    with.restriction.only(group.names, group.words);
  }
  if (all_locked(with.editing, group.names)) {
    if (row_entry(context, "This group again##group", k_not, "Lines and pulls may move this group again"))
      with.restriction.lift();
  } else if (row_entry(context, "Not this group##group", k_not, "Lines and pulls leave this group alone")) {
    with.restriction.without(group.names, group.words);
  }
}

void pair_entries(PanelContext& context, const RowOwners& with, const std::string& left, const std::string& right) {
  const auto parameters = with.editing.document().model->rig->parameters();
  const rig::Pose pose = with.editing.document().pose;
  const auto copy = [&](const std::string& from, const std::string& to) {
    const auto a = rig::find_parameter(parameters, from);
    const auto b = rig::find_parameter(parameters, to);
    if (a && b) with.controls.set_parameter(*b, pose[*a]);
  };
  if (row_entry(context, "Left to right##pair", icon_of(Action::copy_to_right))) copy(left, right);
  if (row_entry(context, "Right to left##pair", icon_of(Action::copy_to_left))) copy(right, left);
}

}  // namespace

bool is_locked(const EditingSession& editing, const std::string& name) {
  const auto& locked = editing.document().locked;
  return std::binary_search(locked.begin(), locked.end(), name);
}

bool all_locked(const EditingSession& editing, const ControlNames& names) {
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) { return is_locked(editing, name); });
}

bool is_sketched(const EditingSession& editing, const std::string& name) {
  const auto& deformers = editing.document().model->deformers;
  return deformers && articulation::find_deformer(*deformers, name).has_value();
}

void ask_for_menu(PanelContext& context, const char* name, bool pressed) {
  const bool held = context.long_press && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
  if (held) context.takes_long_press = true;
  if (held || pressed) ImGui::OpenPopup(name);
}

void show_row_menu(PanelContext& context, const RowOwners& with, const ControlNames& row, const RowGroup& group) {
  if (!begin_menu(context, "row")) return;
  const bool pair = row.size() == 2;
  if (pair) {
    lock_entry(context, with, row, "both");
    lock_entry(context, with, {row[0]}, "left");
    lock_entry(context, with, {row[1]}, "right");
  } else {
    lock_entry(context, with, row, "it");
  }
  for (const std::string& name : row) {
    if (!is_sketched(with.editing, name)) continue;
    const std::string side = !pair ? "" : name == row[0] ? " left" : " right";
    if (row_entry(context, "Redraw" + side + "##redraw " + name, icon_of(Action::tool_pose),
                  "The next stroke goes where the feature should go"))
      with.controls.redraw(name, articulation::CurveRole::target);
  }
  if (row_entry(context, "Reset##reset " + row.front(), icon::k_back, "Back to rest"))
    with.editing.perform(document::ResetParameters{row});
  for (const std::string& name : row)
    type_entry(context, with, name,
               !pair            ? "Type a value"
               : name == row[0] ? "Type the left one"
                                : "Type the right one");
  if (pair) pair_entries(context, with, row[0], row[1]);
  restrict_entries(context, with, group);
  ImGui::EndPopup();
}

void show_group_menu(PanelContext& context, const RowOwners& with, const RowGroup& group) {
  if (!begin_menu(context, "group")) return;
  lock_entry(context, with, group.names, "all of it");
  if (row_entry(context, "Reset##reset group", icon::k_back, "Reset the whole group to rest"))
    with.editing.perform(document::ResetParameters{group.names});
  restrict_entries(context, with, group);
  ImGui::EndPopup();
}

bool offers_quick_buttons(const PanelContext& context, ImVec2 from, ImVec2 to) {
  bool& shown = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("##quick"));
  // They stay while one of them is pressed, and none comes under a pen that is pressed already.
  shown = context.hovers && !context.menu_open && (shown || !ImGui::GetIO().MouseDown[0]) &&
          ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
          ImGui::IsMouseHoveringRect(from, to);
  return shown;
}

float quick_buttons_width(const PanelContext& context, const RowOwners& with, const ControlNames& names) {
  const bool redraws = names.size() == 1 && is_sketched(with.editing, names.front());
  return (redraws ? 3.0F : 2.0F) * context.unit;
}

void show_quick_buttons(PanelContext& context, const RowOwners& with, const ControlNames& names,
                        const std::string& label) {
  const bool locked = all_locked(with.editing, names);
  if (lock_button(context, ("##lock " + label).c_str(), locked,
                  locked ? "Locked: nothing moves it. Touch to unlock"
                         : "Lock: no line moves it; the last line is solved again without it"))
    lock_parameters(with.editing, names, !locked);
  ImGui::SameLine(0, 0);
  if (names.size() == 1 && is_sketched(with.editing, names.front())) {
    if (quiet_icon(context, ("##redraw " + label).c_str(), icon_of(Action::tool_pose),
                   "Redraw: the next stroke goes where the feature should go"))
      with.controls.redraw(names.front(), articulation::CurveRole::target);
    ImGui::SameLine(0, 0);
  }
  if (quiet_icon(context, ("\u21ba##reset " + label).c_str(), icon::k_back, "Back to rest"))
    with.editing.perform(document::ResetParameters{names});
}

}  // namespace penpose::app
