#include "ui/app/panels/side/control_rows.h"

#include <algorithm>
#include <utility>

#include "ui/app/input/side_pairs.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// In targets of a pen: sliders of a row want so much and take no less, and names want no less.
constexpr float k_sliders = 5.2F, k_least_sliders = 3.6F, k_least_name = 3;

/// A row while it is shown.
struct ShownRow {
  const ControlRow& row;
  const ControlRowLook& look;
  const RowGroup& group;
  const RowOwners& with;
  ControlNames names;
  std::string words;
};

/// The name in files, after the words where they do not stand on the slider as a whole.
std::string slider_tip(PanelContext& context, const document::ControlWords& words, const std::string& name,
                       const std::string& shown, float width) {
  const std::string text = words.text();
  const std::string tip = tip_of_control(words, name);
  const float room = width - ImGui::CalcTextSize("-0.00").x - context.unit;
  return shown == text && ImGui::CalcTextSize(text.c_str()).x <= room ? tip : text + "\n" + tip;
}

void slider_of(PanelContext& context, const ShownRow& of, std::size_t index, const std::string& shown_name,
               float width) {
  const RowOwners& with = of.with;
  const document::Document& document = with.editing.document();
  const rig::Parameter parameter = document.model->rig->parameters()[index];
  const rig::Pose& shown = with.editing.shown().pose();
  // While a control is sketched another model may be shown, with another number of parameters.
  double value = index < shown.size() ? shown[index] : document.pose[index];
  SliderLook look{width, parameter.name, shown_name, parameter.rest, is_locked(with.editing, parameter.name)};
  look.shy = true;
  look.changes = index < of.look.seen.size() && of.look.seen[index] != value;
  bool released = false;
  ImGui::PushID(static_cast<int>(index));
  if (control_slider(context, "##value", value, parameter.minimum, parameter.maximum, look, released)) {
    with.controls.preview_parameter(index, value);
  }
  const bool asks = context.long_press && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
  note(context, ("words " + (shown_name.empty() ? with.editing.words()[index].text() : shown_name)).c_str());
  tooltip(context, slider_tip(context, with.editing.words()[index], parameter.name, shown_name, width).c_str());
  if (released) with.controls.set_parameter(index, value);
  ImGui::PopID();
  if (!asks) return;
  context.takes_long_press = true;
  ImGui::OpenPopup("row");
}

/// The name in its column. Under the pointer it gives room to what is done to it most.
void name_of_row(PanelContext& context, const ShownRow& of, const std::string& label) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float wide = of.look.name;
  const bool hovered = offers_quick_buttons(context, from, {from.x + wide, from.y + context.unit});
  const float room = wide - (hovered ? quick_buttons_width(context, of.with, of.names) : 0);
  const bool pressed = ImGui::InvisibleButton("##name", {std::max(1.0F, room), context.unit});
  note(context, ("name " + of.names.front()).c_str());
  ask_for_menu(context, "row", pressed);
  tooltip(context, (of.words + "\n" + label + "\nTouch for all that can be done with it").c_str());
  const std::string shown = fitted_text(of.words, std::max(0.0F, room - context.gap));
  ImGui::GetWindowDrawList()->AddText({from.x, from.y + 0.5F * (context.unit - ImGui::GetFontSize())},
                                      ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
  if (hovered) {
    ImGui::SameLine(0, 0);
    show_quick_buttons(context, of.with, of.names, label);
  }
  ImGui::SameLine(0, 0);
  ImGui::SetCursorScreenPos({from.x + wide, from.y});
}

void show_one(PanelContext& context, const ShownRow& of) {
  const std::string name = of.names.front();
  if (of.look.name > 0) name_of_row(context, of, name);
  slider_of(context, of, of.row.first, of.look.name > 0 ? "" : of.words, ImGui::GetContentRegionAvail().x);
}

void show_pair(PanelContext& context, const ShownRow& of) {
  const std::string both = common_name(of.names[0], of.names[1]);
  if (of.look.name > 0) {
    name_of_row(context, of, both);
  } else {
    ImGui::PushFont(small_font());
    ImGui::TextUnformatted(fitted_text(of.words, ImGui::GetContentRegionAvail().x).c_str());
    tooltip(context, both.c_str());
    ImGui::PopFont();
  }
  const float width = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  slider_of(context, of, of.row.first, "L", width);
  note(context, ("words " + of.words).c_str());
  ImGui::SameLine();
  slider_of(context, of, of.row.second, "R", width);
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

ControlNames names_in(const ControlRow& row, std::span<const rig::Parameter> parameters) {
  ControlNames names{parameters[row.first].name};
  if (row.pair()) names.push_back(parameters[row.second].name);
  return names;
}

std::string words_in(const ControlRow& row, std::span<const document::ControlWords> words) {
  return row.pair() ? words_of_pair(words[row.first], words[row.second]) : words[row.first].text();
}

float name_column(const PanelContext& context, float room, float longest) {
  const float wanted = std::max(longest + context.gap, k_least_name * context.unit);
  const float most = room - std::max(k_least_sliders * context.unit, 0.52F * room);
  return most < k_least_name * context.unit ? 0 : std::min(wanted, most);
}

float whole_rows_width(const PanelContext& context, float longest) {
  return longest + context.gap + std::max(k_sliders * context.unit, longest + context.gap);
}

void show_control_row(PanelContext& context, const ControlRow& row, const ControlRowLook& look, const RowGroup& group,
                      const RowOwners& with) {
  const ShownRow of{row,
                    look,
                    group,
                    with,
                    names_in(row, with.editing.document().model->rig->parameters()),
                    words_in(row, with.editing.words())};
  ImGui::PushID(static_cast<int>(row.first));
  if (row.pair()) {
    show_pair(context, of);
  } else {
    show_one(context, of);
  }
  show_row_menu(context, with, of.names, group);
  ImGui::PopID();
}

}  // namespace penpose::app
