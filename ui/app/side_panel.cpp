#include <algorithm>
#include <set>
#include <utility>

#include "ui/app/panels.h"
#include "ui/app/widgets.h"

// The panel at the side, and in it all parameters.

namespace penpose::app {
namespace {

/// With more parameters than these they stand in groups.
constexpr std::size_t k_many = 16;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool contains(std::string_view name, std::string_view part) {
  return std::search(name.begin(), name.end(), part.begin(), part.end(),
                     [](char a, char b) { return lower(a) == lower(b); }) != name.end();
}

/// The first word of a name ("browInner_L": "brow"), by which parameters are grouped.
std::string first_word(std::string_view name) {
  std::size_t end = 0;
  while (end < name.size() && name[end] >= 'a' && name[end] <= 'z') ++end;
  return end > 1 ? std::string(name.substr(0, end)) : std::string();
}

void parameter_row(PanelContext& context, std::size_t index) {
  App& app = context.app;
  const document::Document& document = app.workspace().document();
  const rig::Parameter& parameter = document.model->rig->parameters()[index];
  const rig::Pose& shown = app.workspace().shown_pose();
  // While a control is sketched another model may be shown, with another number of parameters.
  double value = index < shown.size() ? shown[index] : document.pose[index];
  const bool locked = std::binary_search(document.locked.begin(), document.locked.end(), parameter.name);
  ImGui::PushID(static_cast<int>(index));
  if (lock_button(context, ("##lock " + parameter.name).c_str(), locked,
                  locked ? "Locked: no stroke moves it. Touch to free it"
                         : "Touch to lock it: no stroke will move it, and the last one is solved again without it")) {
    app.workspace().lock({parameter.name}, !locked);
  }
  ImGui::SameLine();
  bool released = false;
  const float width = ImGui::GetContentRegionAvail().x - 2 * (context.unit + ImGui::GetStyle().ItemSpacing.x);
  if (tall_slider(context, "##value", value, parameter.minimum, parameter.maximum, width, parameter.name, released)) {
    app.preview_parameter(index, value);
  }
  if (released) app.set_parameter(index, value);
  ImGui::SameLine();
  const std::string type = "\u270e##type " + parameter.name;
  if (wide_button(context, type.c_str(), context.unit, false, "Type its value, or change its range")) {
    app.panels().number = {parameter.name, {}, NumberEntry::Field::value};
    app.panels().dialog = Dialog::number;
  }
  ImGui::SameLine();
  if (wide_button(context, "\u21ba##reset", context.unit, false, "Back to rest")) {
    app.workspace().perform(document::ResetParameters{{parameter.name}});
  }
  ImGui::PopID();
}

/// A group's name, which folds it, and what is done to all of it. True while it is unfolded.
bool group_row(PanelContext& context, const std::string& group, const std::vector<std::string>& members) {
  App& app = context.app;
  auto& folded = app.panels().folded_groups;
  const auto& locked = app.workspace().document().locked;
  const bool open = !folded.contains(group);
  const bool all_locked = std::all_of(members.begin(), members.end(), [&](const std::string& name) {
    return std::binary_search(locked.begin(), locked.end(), name);
  });
  ImGui::PushID(group.c_str());
  const float width = ImGui::GetContentRegionAvail().x - 2 * (context.unit + ImGui::GetStyle().ItemSpacing.x);
  const std::string label =
      (open ? "\u25be  " : "\u25b8  ") + group + "  " + std::to_string(members.size()) + "##group " + group;
  if (wide_button(context, label.c_str(), width, false, open ? "Fold this group" : "Unfold this group")) {
    if (open) {
      folded.insert(group);
    } else {
      folded.erase(group);
    }
  }
  ImGui::SameLine();
  if (lock_button(context, ("##lock group " + group).c_str(), all_locked,
                  all_locked ? "Free the whole group" : "Lock the whole group: no stroke will move it")) {
    app.workspace().lock(members, !all_locked);
  }
  ImGui::SameLine();
  if (wide_button(context, ("\u21ba##reset group " + group).c_str(), context.unit, false,
                  "The whole group back to rest")) {
    app.workspace().perform(document::ResetParameters{members});
  }
  ImGui::PopID();
  return open;
}

}  // namespace

void show_parameters(PanelContext& context) {
  App& app = context.app;
  text_field(context, "##search", app.panels().filter, ImGui::GetContentRegionAvail().x - context.unit - context.gap,
             "search");
  ImGui::SameLine();
  if (wide_button(context, "x##clear", context.unit, false, "Show all")) app.panels().filter.clear();
  ImGui::BeginChild("list");
  // The order is kept; a group is a run of one first word.
  std::string group;
  bool open = true;
  bool found = false;
  for (std::size_t i = 0; i < app.workspace().document().model->rig->parameters().size(); ++i) {
    // A row may perform a command that makes another rig.
    const auto now = app.workspace().document().model->rig->parameters();
    if (!app.panels().filter.empty()) {
      if (!contains(now[i].name, app.panels().filter)) continue;
      found = true;
      parameter_row(context, i);
      continue;
    }
    const std::string word = first_word(now[i].name);
    if (now.size() > k_many && word != group) {
      group = word;
      open = true;
      std::vector<std::string> members;
      for (std::size_t k = i; k < now.size() && first_word(now[k].name) == word; ++k) members.push_back(now[k].name);
      if (!word.empty() && members.size() > 1) open = group_row(context, group, members);
    }
    if (open) parameter_row(context, i);
  }
  if (!app.panels().filter.empty() && !found) ImGui::TextWrapped("Nothing has this in its name.");
  if (app.workspace().document().model->rig->parameters().empty()) {
    ImGui::TextWrapped("This model has nothing to pose yet. Take the tool Rig and sketch a control.");
  }
  ImGui::EndChild();
}

void show_side_panel(PanelContext& context, const Area& area) {
  App& app = context.app;
  if (begin_panel(context, "side", area)) {
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - context.gap);
    if (wide_button(context, "Parameters", half, !app.panels().controls_tab)) app.panels().controls_tab = false;
    ImGui::SameLine();
    if (wide_button(context, "Controls", half, app.panels().controls_tab)) app.panels().controls_tab = true;
    if (app.panels().controls_tab) {
      show_deformers(context);
    } else {
      show_parameters(context);
    }
  }
  end_panel();
}

}  // namespace penpose::app
