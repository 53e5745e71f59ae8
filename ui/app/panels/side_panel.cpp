#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/text/letters.h"
#include "ui/app/controls/control_parts.h"
#include "ui/app/panels/control_rows.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// The panel at the side, and in it all parameters.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct SidePanelOwners {
  EditingSession& editing;
  Controls& controls;
  Dialogs& dialogs;
  PanelState& panels;
};

/// Groups by the parts of the face, in the order of FacePart. First words begin small.
constexpr std::array<const char*, 4> k_parts{"Others", "Brows", "Eyes", "Mouth"};
/// A group that holds a greater share of the shapes tells nothing.
constexpr double k_one_group = 0.8;
/// With more parameters than these they stand in groups.
constexpr std::size_t k_many = 16;
/// Share of its range from which on a control is away from rest.
constexpr double k_moved_value = 0.005;

bool contains(std::string_view name, std::string_view part) {
  return std::search(name.begin(), name.end(), part.begin(), part.end(),
                     [](char a, char b) { return base::lower(a) == base::lower(b); }) != name.end();
}

/// The first word of a name ("browInner_L": "brow"), by which parameters are grouped.
std::string first_word(std::string_view name) {
  std::size_t end = 0;
  while (end < name.size() && name[end] >= 'a' && name[end] <= 'z') ++end;
  return end > 1 ? std::string(name.substr(0, end)) : std::string();
}

/// The groups of parameters, one each: by the first words of their names; where nearly all shapes begin alike, which
/// tells nothing, by the parts of the face that they move.
std::vector<std::string> groups_of(const SidePanelOwners& with) {
  const document::Document& document = with.editing.document();
  const auto parameters = document.model->rig->parameters();
  std::vector<std::string> groups;
  std::map<std::string, std::size_t> counts;
  const std::size_t shapes = document::weight_count(*document.model);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    groups.push_back(first_word(parameters[i].name));
    if (i < shapes) ++counts[groups.back()];
  }
  const auto alike = std::any_of(counts.begin(), counts.end(), [&](const auto& one) {
    return static_cast<double>(one.second) > k_one_group * static_cast<double>(shapes);
  });
  if (!alike || shapes <= k_many) return groups;
  const auto& parts = with.panels.own.of<ControlParts>().of(document, with.editing.features());
  for (std::size_t i = 0; i < shapes; ++i) groups[i] = k_parts[static_cast<std::size_t>(parts[i])];
  return groups;
}

/// Frees one group and locks all others, or frees all again.
void solo_button(PanelContext& context, const SidePanelOwners& with, const std::string& group,
                 const std::vector<std::string>& members) {
  const document::Document& document = with.editing.document();
  std::vector<std::string> others;
  for (const auto& parameter : document.model->rig->parameters()) {
    if (std::find(members.begin(), members.end(), parameter.name) == members.end()) others.push_back(parameter.name);
  }
  std::sort(others.begin(), others.end());
  const bool solo = !others.empty() && document.locked == others;
  if (!wide_button(context, ("S##solo " + group).c_str(), context.unit, solo,
                   solo ? "Free the other groups again" : "This group alone: all others are locked")) {
    return;
  }
  if (solo) {
    with.editing.perform(document::LockParameters{others, false});
    return;
  }
  std::vector<std::string> locked_here;
  for (const std::string& name : members) {
    if (std::binary_search(document.locked.begin(), document.locked.end(), name)) locked_here.push_back(name);
  }
  if (!with.editing.perform(document::LockParameters{others, true})) return;
  if (!locked_here.empty()) with.editing.perform_with(document::LockParameters{locked_here, false});
}

/// A group's name, which folds it, and what is done to all of it. True while it is unfolded.
bool group_row(PanelContext& context, const SidePanelOwners& with, const std::string& group,
               const std::vector<std::string>& members) {
  auto& folded = with.panels.own.of<ParameterList>().folded;
  const auto& locked = with.editing.document().locked;
  const bool open = !folded.contains(group);
  const bool all_locked = std::all_of(members.begin(), members.end(), [&](const std::string& name) {
    return std::binary_search(locked.begin(), locked.end(), name);
  });
  ImGui::PushID(group.c_str());
  const float width = ImGui::GetContentRegionAvail().x - 3 * (context.unit + ImGui::GetStyle().ItemSpacing.x);
  const std::string label =
      (open ? "\u25be  " : "\u25b8  ") + group + "  " + std::to_string(members.size()) + "##group " + group;
  ButtonLook look{width, false, open ? "Fold this group" : "Unfold this group"};
  look.left_aligned = true;
  look.weight = ButtonWeight::quiet;
  if (icon_button(context, label.c_str(), look)) {
    if (open) {
      folded.insert(group);
    } else {
      folded.erase(group);
    }
  }
  ImGui::SameLine();
  solo_button(context, with, group, members);
  ImGui::SameLine();
  if (lock_button(context, ("##lock group " + group).c_str(), all_locked,
                  all_locked ? "Free the whole group" : "Lock the whole group: no stroke will move it")) {
    lock_parameters(with.editing, members, !all_locked);
  }
  ImGui::SameLine();
  if (quiet_icon(context, ("\u21ba##reset group " + group).c_str(), icon::k_back, "The whole group back to rest")) {
    with.editing.perform(document::ResetParameters{members});
  }
  ImGui::PopID();
  return open;
}

/// Which parameters are listed: those whose words or names say what is searched for, and where it is asked for those
/// alone that are not at rest. One that is locked there goes on being listed, so that it can be freed where it was
/// locked.
std::vector<bool> wanted_parameters(const SidePanelOwners& with) {
  const auto parameters = with.editing.document().model->rig->parameters();
  const auto& locked = with.editing.document().locked;
  const rig::Pose& shown = with.editing.shown().pose();
  ParameterList& list = with.panels.own.of<ParameterList>();
  if (!list.moved_only) list.moved.clear();
  std::vector<bool> wanted(parameters.size());
  const auto words = with.editing.words();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string& name = parameters[i].name;
    const double by = i < shown.size() ? std::abs(shown[i] - parameters[i].rest) : 0;
    bool moved = by >= k_moved_value * (parameters[i].maximum - parameters[i].minimum);
    if (list.moved_only) {
      moved = moved || (list.moved.contains(name) && std::binary_search(locked.begin(), locked.end(), name));
      if (moved) {
        list.moved.insert(name);
      } else {
        list.moved.erase(name);
      }
    }
    const bool said = list.filter.empty() || contains(name, list.filter) || contains(words[i].text(), list.filter);
    wanted[i] = said && (moved || !list.moved_only);
  }
  return wanted;
}

/// Rows of groups by the parts of the face one after the other; those of other groups stay.
void join_groups(std::vector<ControlRow>& rows, const std::vector<std::string>& groups) {
  const auto rank = [&](const ControlRow& row) {
    constexpr std::array k_order{k_parts[1], k_parts[2], k_parts[3], k_parts[0]};
    return std::find(k_order.begin(), k_order.end(), groups[row.first]) - k_order.begin();
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const ControlRow& a, const ControlRow& b) { return rank(a) < rank(b); });
}

void show_list(PanelContext& context, const SidePanelOwners& with) {
  // A row may perform a command that makes another rig: the list is of the one there was.
  const auto rig = with.editing.document().model->rig;
  const auto parameters = rig->parameters();
  auto rows = control_rows(parameters, wanted_parameters(with));
  const bool grouped = with.panels.own.of<ParameterList>().filter.empty() &&
                       !with.panels.own.of<ParameterList>().moved_only && parameters.size() > k_many;
  const auto groups = grouped ? groups_of(with) : std::vector<std::string>(parameters.size());
  if (grouped) join_groups(rows, groups);
  std::string group;
  bool open = true;
  for (std::size_t i = 0; i < rows.size() && with.editing.document().model->rig == rig; ++i) {
    const std::string& word = groups[rows[i].first];
    if (grouped && word != group) {
      group = word;
      open = true;
      std::vector<std::string> members;
      for (std::size_t k = i; k < rows.size() && groups[rows[k].first] == word; ++k) {
        members.push_back(parameters[rows[k].first].name);
        if (rows[k].pair()) members.push_back(parameters[rows[k].second].name);
      }
      if (!word.empty() && members.size() > 1) open = group_row(context, with, group, members);
    }
    if (open && with.editing.document().model->rig == rig)
      show_control_row(context, rows[i], with.editing, with.controls, with.dialogs);
  }
  if (!rows.empty()) return;
  if (parameters.empty()) {
    ImGui::TextWrapped("This model has nothing to pose yet. Take the tool Rig and sketch a control.");
  } else {
    ImGui::TextWrapped(with.panels.own.of<ParameterList>().filter.empty() ? "Everything is at rest."
                                                                          : "Nothing has this in its name.");
  }
}

}  // namespace

void show_parameters(PanelContext& context, EditingSession& editing, Controls& controls, Dialogs& dialogs,
                     PanelState& panels) {
  const SidePanelOwners with{editing, controls, dialogs, panels};
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float moved = button_width(context, "Moved", {}, true);
  text_field(context, "##search", panels.own.of<ParameterList>().filter,
             ImGui::GetContentRegionAvail().x - context.unit - moved - 2 * spacing, "search");
  ImGui::SameLine();
  if (quiet_icon(context, "x##clear", icon::k_cross, "Show all")) {
    panels.own.of<ParameterList>().filter.clear();
    panels.own.of<ParameterList>().moved_only = false;
  }
  ImGui::SameLine();
  action_button(context, Action::moved_only, moved, panels.own.of<ParameterList>().moved_only, "Moved");
  begin_list(context, "list", {});
  show_list(context, with);
  ImGui::EndChild();
}

void show_side_panel(PanelContext& context, const Area& area, EditingSession& editing, Canvas& canvas,
                     Controls& controls, Playback& playback, Notices& notices, KeptMouths& mouths, Dialogs& dialogs,
                     PanelState& panels, PoseShelf& shelf) {
  if (begin_panel(context, "side", area, true)) {
    if (panels.controls_tab) panels.poses_tab = panels.mouths_tab = false;
    const bool parameters = !panels.controls_tab && !panels.pictured();
    struct Tab {
      const char* label;
      bool chosen;
      const char* tip;
      bool PanelState::*part;
    };
    const std::array<Tab, 4> tabs{
        {{"Parameters", parameters, "Everything that moves the model, as sliders", nullptr},
         {"Controls", panels.controls_tab, "Controls that were sketched, and new ones", &PanelState::controls_tab},
         {"Poses", panels.poses_tab, "Poses that are keyed, and the library", &PanelState::poses_tab},
         {"Mouths", panels.mouths_tab, "The mouths that speech is drawn with", &PanelState::mouths_tab}}};
    // As wide as their words want.
    float words = 0;
    for (const Tab& tab : tabs) words += ImGui::CalcTextSize(tab.label).x;
    const float pad = (ImGui::GetContentRegionAvail().x - 3 * ImGui::GetStyle().ItemSpacing.x - words) / 4;
    for (const Tab& tab : tabs) {
      if (tab.part != nullptr) ImGui::SameLine();
      if (!wide_button(context, tab.label, ImGui::CalcTextSize(tab.label).x + pad, tab.chosen, tab.tip)) continue;
      panels.controls_tab = panels.poses_tab = panels.mouths_tab = false;
      if (tab.part != nullptr) panels.*tab.part = true;
    }
    if (panels.mouths_tab) {
      show_mouths(context, editing, mouths, dialogs, panels);
    } else if (panels.poses_tab) {
      show_poses(context, editing, playback, panels, shelf);
    } else if (panels.controls_tab) {
      show_deformers(context, editing, canvas, controls, notices, dialogs, panels);
    } else {
      show_parameters(context, editing, controls, dialogs, panels);
    }
  }
  end_panel();
}

}  // namespace penpose::app
