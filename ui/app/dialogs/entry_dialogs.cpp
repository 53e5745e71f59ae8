#include <array>
#include <cmath>
#include <cstdio>

#include "core/articulation/edit.h"
#include "core/base/numbers.h"
#include "ui/app/controls/controls.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/keys.h"
#include "ui/app/preferences.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"

// Dialogs that take a number or a name: with a pen, or with a keyboard where there is one.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct EntryDialogsOwners {
  EditingSession& editing;
  Controls& controls;
  Notices& notices;
  Dialogs& dialogs;
};

/// The place of the pen's menu that is being chosen for.
struct RadialEntry {
  std::size_t place = 0;
};

std::string shown(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

/// Sets what was typed. False, and said why, where it is none or does not fit.
bool take_number(const EntryDialogsOwners& with, std::size_t index) {
  const NumberEntry& entry = with.dialogs.state<NumberEntry>();
  const auto value = base::parse_double(entry.text);
  if (!value || !std::isfinite(*value)) {
    with.notices.tell("\"" + entry.text + "\" is no number", true);
    return false;
  }
  const rig::Parameter parameter = with.editing.document().model->rig->parameters()[index];
  if (entry.field == NumberEntry::Field::value) {
    if (*value < parameter.minimum || *value > parameter.maximum) {
      with.notices.tell(with.editing.words_of(parameter.name) + " goes from " + shown(parameter.minimum) + " to " +
                        shown(parameter.maximum));
    }
    with.controls.set_parameter(index, *value);
    return true;
  }
  document::ChangeDeformer change;
  change.deformer = parameter.name;
  (entry.field == NumberEntry::Field::least ? change.minimum : change.maximum) = *value;
  return with.editing.perform(change);
}

void keypad(PanelContext& context, std::string& text) {
  constexpr std::array<std::array<const char*, 3>, 4> k_rows{
      {{"7", "8", "9"}, {"4", "5", "6"}, {"1", "2", "3"}, {"-", "0", "."}}};
  const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  for (const auto& row : k_rows) {
    for (const char* key : row) {
      if (key != row[0]) ImGui::SameLine();
      if (wide_button(context, (std::string(key) + "##pad").c_str(), third)) text += key;
    }
  }
  if (wide_button(context, "Back##pad", third) && !text.empty()) text.pop_back();
  ImGui::SameLine();
  if (wide_button(context, "Clear##pad", third)) text.clear();
}

}  // namespace

void show_number_dialog(PanelContext& context, EditingSession& editing, Controls& controls, Notices& notices,
                        Dialogs& dialogs) {
  const EntryDialogsOwners with{editing, controls, notices, dialogs};
  NumberEntry& entry = dialogs.state<NumberEntry>();
  const auto& model = *editing.document().model;
  const auto index = rig::find_parameter(model.rig->parameters(), entry.parameter);
  if (!index) {
    dialogs.show(Dialog::none);
    return;
  }
  const rig::Parameter parameter = model.rig->parameters()[*index];
  const bool has_range = model.deformers && articulation::find_deformer(*model.deformers, parameter.name).has_value();
  if (begin_dialog(context, (editing.words_of(parameter.name) + "###number").c_str(), 9)) {
    using Field = NumberEntry::Field;
    const std::array<std::pair<Field, std::string>, 3> fields{
        {{Field::value, "Value " + shown(editing.document().pose[*index])},
         {Field::least, "Least " + shown(parameter.minimum)},
         {Field::most, "Most " + shown(parameter.maximum)}}};
    const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    for (const auto& [field, label] : fields) {
      if (field != Field::value) ImGui::SameLine();
      ImGui::BeginDisabled(field != Field::value && !has_range);
      const std::string id = label + "###field" + std::to_string(static_cast<int>(field));
      if (wide_button(context, id.c_str(), third, entry.field == field, "What is typed sets this")) {
        entry.field = field;
        entry.text.clear();
      }
      ImGui::EndDisabled();
    }
    dialog_field(context, "##number", entry.text, "type a number");
    keypad(context, entry.text);
    ImGui::Dummy({1, context.gap});
    if ((primary_button(context, "Set##number", third) || context.accepts) && take_number(with, *index)) {
      dialogs.show(Dialog::none);
    }
    ImGui::SameLine();
    if (wide_button(context, "Rest##number", third, false, "Back to rest")) {
      editing.perform(document::ResetParameters{{parameter.name}});
      dialogs.show(Dialog::none);
    }
    ImGui::SameLine();
    if (wide_button(context, "Cancel", third)) dialogs.show(Dialog::none);
  }
  end_dialog();
}

void show_key_dialog(PanelContext& context, Keys& keys, Dialogs& dialogs) {
  std::string& name = dialogs.state<KeyNameEntry>().text;
  if (begin_dialog(context, "A name for this pose", 11)) {
    dialog_field(context, "##key name", name, "smile");
    if (primary_button(context, "Name it", 4 * context.unit) || context.accepts) {
      keys.name(name);
      dialogs.show(Dialog::none);
    }
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) dialogs.show(Dialog::none);
  }
  end_dialog();
}

void show_radial_dialog(PanelContext& context, Preferences& preferences, Dialogs& dialogs) {
  auto& radial = preferences.settings().radial;
  std::size_t& place = dialogs.state<RadialEntry>().place;
  if (begin_dialog(context, "The menu around the pen", 15)) {
    ImGui::TextWrapped("Touch a place of the menu, clockwise from the top, then what it should do.");
    const float quarter = (ImGui::GetContentRegionAvail().x - 3 * ImGui::GetStyle().ItemSpacing.x) / 4;
    for (std::size_t i = 0; i < radial.size(); ++i) {
      if (i % 4 != 0) ImGui::SameLine();
      const std::string label = std::string(info(radial[i]).label) + "##place" + std::to_string(i);
      if (wide_button(context, label.c_str(), quarter, place == i)) place = i;
    }
    begin_list(context, "actions", {0, 6 * context.unit}, true);
    const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    int column = 0;
    for (const ActionInfo& one : all_actions()) {
      if (column++ % 3 != 0) ImGui::SameLine();
      const std::string label = std::string(one.label) + "##choose";
      const std::string tip(one.tip);
      ButtonLook look{third, false, tip.c_str(), one.icon};
      look.left_aligned = true;
      look.weight = ButtonWeight::quiet;
      if (icon_button(context, label.c_str(), look) && place < radial.size()) {
        radial[place] = one.action;
        preferences.changed();
      }
    }
    ImGui::EndChild();
    if (wide_button(context, "Reset##radial menu")) {
      radial = Settings().radial;
      preferences.changed();
    }
    ImGui::SameLine();
    if (primary_button(context, "Done") || context.accepts) dialogs.show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
