#include "ui/app/panels/control_rows.h"

#include <algorithm>
#include <utility>

#include "ui/app/controls/controls.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/input/side_pairs.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct ControlRowsOwners {
  EditingSession& editing;
  Controls& controls;
  Dialogs& dialogs;
};

bool is_locked(const ControlRowsOwners& with, const std::string& name) {
  const auto& locked = with.editing.document().locked;
  return std::binary_search(locked.begin(), locked.end(), name);
}

void lock_of(PanelContext& context, const ControlRowsOwners& with, const std::string& name) {
  const bool locked = is_locked(with, name);
  if (lock_button(context, ("##lock " + name).c_str(), locked,
                  locked ? "Locked: neither a stroke nor its slider moves it. Touch to free it"
                         : "Touch to lock it: no stroke will move it, and the last one is solved again without it")) {
    lock_parameters(with.editing, {name}, !locked);
  }
}

/// The name in files, after the words where they do not stand on the slider as a whole.
std::string slider_tip(PanelContext& context, const document::ControlWords& words, const std::string& name,
                       const std::string& shown, float width) {
  const std::string text = words.text();
  const std::string tip = tip_of_control(words, name);
  const float room = width - ImGui::CalcTextSize("-0.00").x - context.unit;
  return shown == text && ImGui::CalcTextSize(text.c_str()).x <= room ? tip : text + "\n" + tip;
}

void slider_of(PanelContext& context, const ControlRowsOwners& with, std::size_t index, const std::string& shown_name,
               float width) {
  const document::Document& document = with.editing.document();
  const rig::Parameter parameter = document.model->rig->parameters()[index];
  const rig::Pose& shown = with.editing.shown().pose();
  // While a control is sketched another model may be shown, with another number of parameters.
  double value = index < shown.size() ? shown[index] : document.pose[index];
  SliderLook look{width, parameter.name, shown_name, parameter.rest, is_locked(with, parameter.name)};
  bool released = false;
  ImGui::PushID(static_cast<int>(index));
  if (control_slider(context, "##value", value, parameter.minimum, parameter.maximum, look, released)) {
    with.controls.preview_parameter(index, value);
  }
  note(context, ("words " + shown_name).c_str());
  tooltip(context, slider_tip(context, with.editing.words()[index], parameter.name, shown_name, width).c_str());
  if (released) with.controls.set_parameter(index, value);
  ImGui::PopID();
}

void type_value(const ControlRowsOwners& with, const std::string& name) {
  with.dialogs.state<NumberEntry>() = {name, {}, NumberEntry::Field::value};
  with.dialogs.show(Dialog::number);
}

void show_one(PanelContext& context, const ControlRowsOwners& with, std::size_t index) {
  const std::string name = with.editing.document().model->rig->parameters()[index].name;
  lock_of(context, with, name);
  ImGui::SameLine();
  const float width = ImGui::GetContentRegionAvail().x - 2 * (context.unit + ImGui::GetStyle().ItemSpacing.x);
  slider_of(context, with, index, with.editing.words()[index].text(), width);
  ImGui::SameLine();
  if (quiet_icon(context, ("\u270e##type " + name).c_str(), icon::k_pencil, "Type its value, or change its range"))
    type_value(with, name);
  ImGui::SameLine();
  if (quiet_icon(context, ("\u21ba##reset " + name).c_str(), icon::k_back, "Back to rest")) {
    with.editing.perform(document::ResetParameters{{name}});
  }
}

/// What is done to a pair besides moving it.
void pair_menu(PanelContext& context, const ControlRowsOwners& with, const std::string& left,
               const std::string& right) {
  const std::string both = common_name(left, right);
  if (quiet_icon(context, ("more##pair " + both).c_str(), icon::k_more, "Type a value, copy a side, back to rest")) {
    ImGui::OpenPopup("pair");
  }
  if (!begin_menu(context, "pair")) return;
  const auto parameters = with.editing.document().model->rig->parameters();
  const rig::Pose pose = with.editing.document().pose;
  const auto entry = [&](const std::string& label, std::string_view drawn) {
    const bool pressed = menu_entry(context, label.c_str(), drawn, {}, nullptr);
    if (pressed) ImGui::CloseCurrentPopup();
    return pressed;
  };
  const auto copy = [&](const std::string& from, const std::string& to) {
    const auto a = rig::find_parameter(parameters, from);
    const auto b = rig::find_parameter(parameters, to);
    if (a && b) with.controls.set_parameter(*b, pose[*a]);
  };
  for (const std::string& name : {left, right}) {
    if (entry("Type " + with.editing.words_of(name) + "##type " + name, icon::k_pencil)) type_value(with, name);
  }
  if (entry("Left to right##pair", icon_of(Action::copy_to_right))) copy(left, right);
  if (entry("Right to left##pair", icon_of(Action::copy_to_left))) copy(right, left);
  if (entry("Both to rest##pair", icon::k_back)) with.editing.perform(document::ResetParameters{{left, right}});
  ImGui::EndPopup();
}

void show_pair(PanelContext& context, const ControlRowsOwners& with, const ControlRow& row) {
  const auto parameters = with.editing.document().model->rig->parameters();
  const std::string left = parameters[row.first].name;
  const std::string right = parameters[row.second].name;
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  ImGui::PushFont(small_font());
  const auto words = with.editing.words();
  const std::string both = words_of_pair(words[row.first], words[row.second]);
  ImGui::TextUnformatted(fitted_text(both, ImGui::GetContentRegionAvail().x).c_str());
  tooltip(context, common_name(left, right).c_str());
  ImGui::PopFont();
  lock_of(context, with, left);
  ImGui::SameLine();
  const float width = 0.5F * (ImGui::GetContentRegionAvail().x - 2 * (context.unit + spacing) - spacing);
  slider_of(context, with, row.first, "L", width);
  note(context, ("words " + both).c_str());
  ImGui::SameLine();
  slider_of(context, with, row.second, "R", width);
  ImGui::SameLine();
  lock_of(context, with, right);
  ImGui::SameLine();
  pair_menu(context, with, left, right);
}

}  // namespace

std::vector<ControlRow> control_rows(std::span<const rig::Parameter> parameters, const std::vector<bool>& wanted) {
  const auto pairs = side_pairs(parameters);
  std::vector<ControlRow> rows;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::size_t other = pairs[i];
    if (other == k_no_pair) {
      if (wanted[i]) rows.push_back({i});
      continue;
    }
    if (other < i || (!wanted[i] && !wanted[other])) continue;
    const bool left_first = is_left(parameters[i].name, parameters[other].name);
    rows.push_back(left_first ? ControlRow{i, other} : ControlRow{other, i});
  }
  return rows;
}

void show_control_row(PanelContext& context, const ControlRow& row, EditingSession& editing, Controls& controls,
                      Dialogs& dialogs) {
  const ControlRowsOwners with{editing, controls, dialogs};
  ImGui::PushID(static_cast<int>(row.first));
  if (row.pair()) {
    show_pair(context, with, row);
  } else {
    show_one(context, with, row.first);
  }
  ImGui::PopID();
}

}  // namespace penpose::app
