#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/text/letters.h"
#include "ui/app/controls/control_groups.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/side/control_rows.h"
#include "ui/app/panels/side/side_width.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// All parameters, in groups by the parts of the figure; on top those that are not at rest.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct SidePanelOwners {
  EditingSession& editing;
  Controls& controls;
  Dialogs& dialogs;
  PanelState& panels;
  Restriction& restriction;
  [[nodiscard]] RowOwners rows() const { return {editing, controls, dialogs, restriction}; }
};

/// With more parameters than these they stand in groups.
constexpr std::size_t k_many = 6;
/// Share of its range from which on a control is away from rest.
constexpr double k_moved_value = 0.005;
/// A body with more controls is folded at first.
constexpr std::ptrdiff_t k_large_body = 12;
/// Px between rows, at scale 1.
constexpr float k_row_gap = 2;

/// What the list remembers from frame to frame.
struct ListedRows {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::shared_ptr<const rig::CharacterRig> rig;
  std::vector<double> seen;       ///< values of the frame before
  std::vector<ControlRow> moved;  ///< rows of the group "Moved"
  float scrolled_for = 0;         ///< px by which the list was scrolled so that rows stay under the pointer
  float scrolled_to = 0;          ///< and where it then was
  float longest = 0;              ///< the widest name, px
  float measured_at = 0;          ///< size of letters
};

bool contains(std::string_view name, std::string_view part) {
  return std::search(name.begin(), name.end(), part.begin(), part.end(),
                     [](char a, char b) { return base::lower(a) == base::lower(b); }) != name.end();
}

/// A group's name, which folds it, and what is done to all of it. True while it is unfolded.
bool group_row(PanelContext& context, const SidePanelOwners& with, const std::string& group, std::size_t rows,
               const RowGroup& members) {
  auto& folded = with.panels.own.of<ParameterList>().folded;
  const bool open = !folded.contains(group);
  ImGui::PushID(group.c_str());
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float wide = ImGui::GetContentRegionAvail().x;
  const bool hovered = offers_quick_buttons(context, from, {from.x + wide, from.y + context.unit});
  const float buttons = hovered ? quick_buttons_width(context, with.rows(), members.names) : 0;
  const std::string label = (open ? "\u25be  " : "\u25b8  ") + group + "  " + std::to_string(rows) + "##group " + group;
  ButtonLook look{wide - buttons, false, open ? "Fold this group; a long press opens its menu" : "Unfold this group"};
  look.left_aligned = true;
  look.weight = ButtonWeight::quiet;
  const bool pressed = icon_button(context, label.c_str(), look);
  ask_for_menu(context, "group", false);
  if (pressed && open) folded.insert(group);
  if (pressed && !open) folded.erase(group);
  if (hovered) {
    ImGui::SameLine(0, 0);
    show_quick_buttons(context, with.rows(), members.names, "group " + group);
  }
  show_group_menu(context, with.rows(), members);
  ImGui::PopID();
  return open;
}

bool is_moved(const SidePanelOwners& with, std::size_t index) {
  const rig::Parameter& parameter = with.editing.document().model->rig->parameters()[index];
  const rig::Pose& shown = with.editing.shown().pose();
  const double by = index < shown.size() ? std::abs(shown[index] - parameter.rest) : 0;
  return by >= k_moved_value * (parameter.maximum - parameter.minimum);
}

/// Which parameters are listed: those whose words or names say what is searched for, and where it is asked for those
/// alone that are not at rest. One that is locked there goes on being listed, so that it can be freed where it was
/// locked; and all do while the pointer is over them, so that none comes to lie under it that was not meant.
std::vector<bool> wanted_parameters(const SidePanelOwners& with) {
  const auto parameters = with.editing.document().model->rig->parameters();
  ParameterList& list = with.panels.own.of<ParameterList>();
  if (!list.moved_only) list.moved.clear();
  std::vector<bool> wanted(parameters.size());
  const auto words = with.editing.words();
  const bool hovered =
      ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string& name = parameters[i].name;
    bool moved = is_moved(with, i);
    if (list.moved_only) {
      moved = moved || (list.moved.contains(name) && (hovered || is_locked(with.editing, name)));
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

/// Looks at the values of this frame. The rows that are not at rest become the group on top as soon as nothing is in
/// hand any more; what is below the pointer stays there by scrolling.
void follow_moved(const PanelContext& context, const SidePanelOwners& with, const std::vector<ControlRow>& rows,
                  ListedRows& listed, float row_height) {
  const rig::Pose& shown = with.editing.shown().pose();
  const bool still = listed.seen == shown;
  const bool busy = ImGui::IsAnyItemActive() || ImGui::GetIO().MouseDown[0] || with.editing.pen_is_drawing();
  if (!still || busy) return;
  // Once the pointer is elsewhere the top of the list is seen again, unless somebody scrolled it meanwhile.
  const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByPopup);
  const bool elsewhere = !hovered && !context.menu_open;
  if (listed.scrolled_for > 0 && elsewhere) {
    if (std::abs(ImGui::GetScrollY() - listed.scrolled_to) < 1)
      ImGui::SetScrollY(std::max(0.0F, listed.scrolled_to - listed.scrolled_for));
    listed.scrolled_for = 0;
  }
  std::vector<ControlRow> moved;
  for (const ControlRow& row : rows) {
    if (is_moved(with, row.first) || (row.pair() && is_moved(with, row.second))) moved.push_back(row);
  }
  if (moved == listed.moved) return;
  const auto height = [&](const std::vector<ControlRow>& group) {
    const bool folded = with.panels.own.of<ParameterList>().folded.contains("Moved");
    return group.empty() ? 0.0F : row_height * static_cast<float>(folded ? 1 : 1 + group.size());
  };
  const float by = height(moved) - height(listed.moved);
  listed.moved = std::move(moved);
  if (elsewhere) return;
  listed.scrolled_for += by;
  listed.scrolled_to = std::max(0.0F, ImGui::GetScrollY() + by);
  ImGui::SetScrollY(listed.scrolled_to);
}

/// Bodies of many joints are folded at first: their rows would lie between those of the face.
void fold_large_body(const SidePanelOwners& with, ListedRows& listed, const std::vector<ControlGroup>& groups) {
  const auto& mesh = with.editing.document().model->mesh;
  if (listed.mesh == mesh) return;
  listed.mesh = mesh;
  if (std::count(groups.begin(), groups.end(), ControlGroup::body) > k_large_body)
    with.panels.own.of<ParameterList>().folded.insert(std::string(name_of(ControlGroup::body)));
}

/// The widest of the names, px; measured once for a model.
float longest_name(const SidePanelOwners& with, const std::vector<ControlRow>& rows, ListedRows& listed) {
  if (listed.measured_at == ImGui::GetFontSize()) return listed.longest;
  listed.measured_at = ImGui::GetFontSize();
  listed.longest = 0;
  const auto words = with.editing.words();
  for (const ControlRow& row : rows)
    listed.longest = std::max(listed.longest, ImGui::CalcTextSize(words_in(row, words).c_str()).x);
  return listed.longest;
}

/// Rows of one group after the other, as they are shown.
class GroupedRows {
 public:
  GroupedRows(PanelContext& context, const SidePanelOwners& with, ControlRowLook look)
      : context_(context), with_(with), look_(std::move(look)), rig_(with.editing.document().model->rig) {}

  /// `title`: empty: rows without a group.
  void show(const std::string& title, std::span<const ControlRow> rows) {
    RowGroup group{{}, title == "Moved" ? "what is moved" : base::lower_case(title)};
    for (const ControlRow& row : rows) {
      for (std::string& name : names_in(row, rig_->parameters())) group.names.push_back(std::move(name));
    }
    if (rows.empty() || !same_rig()) return;
    if (!title.empty() && !group_row(context_, with_, title, rows.size(), group)) return;
    ImGui::PushID(title.c_str());
    for (const ControlRow& row : rows) {
      if (same_rig()) show_control_row(context_, row, look_, title.empty() ? RowGroup() : group, with_.rows());
    }
    ImGui::PopID();
  }

 private:
  /// A row may perform a command that makes another rig: the list is of the one there was.
  [[nodiscard]] bool same_rig() const { return with_.editing.document().model->rig == rig_; }

  PanelContext& context_;
  const SidePanelOwners& with_;
  ControlRowLook look_;
  std::shared_ptr<const rig::CharacterRig> rig_;
};

void show_groups(PanelContext& context, const SidePanelOwners& with, std::vector<ControlRow> rows, ListedRows& listed) {
  const document::Document& document = with.editing.document();
  const auto& groups = with.panels.own.of<ControlGroups>().of(document, with.editing.words(), with.editing.features());
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const ControlRow& a, const ControlRow& b) { return groups[a.first] < groups[b.first]; });
  fold_large_body(with, listed, groups);
  const ParameterList& list = with.panels.own.of<ParameterList>();
  const float room = ImGui::GetContentRegionAvail().x;
  GroupedRows shown(context, with, {name_column(context, room, listed.longest), listed.seen});
  if (!list.filter.empty() || list.moved_only || groups.size() <= k_many) return shown.show({}, rows);
  shown.show("Moved", listed.moved);
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t end = first;
    while (end < rows.size() && groups[rows[end].first] == groups[rows[first].first]) ++end;
    const std::string title(name_of(groups[rows[first].first]));
    shown.show(title, std::span(rows).subspan(first, end - first));
    first = end;
  }
}

void show_list(PanelContext& context, const SidePanelOwners& with) {
  const auto rig = with.editing.document().model->rig;
  const auto parameters = rig->parameters();
  ListedRows& listed = with.panels.own.of<ListedRows>();
  if (listed.rig != rig) {
    const auto mesh = listed.mesh;
    listed = {};
    listed.mesh = mesh;
  }
  listed.rig = rig;
  const auto all = control_rows(parameters, std::vector<bool>(parameters.size(), true));
  with.panels.own.of<SideWidth>().wanted = whole_rows_width(context, longest_name(with, all, listed)) +
                                           2 * ImGui::GetStyle().WindowPadding.x + ImGui::GetStyle().ScrollbarSize;
  const float between = std::round(k_row_gap * context.gap / 6);
  follow_moved(context, with, all, listed, context.unit + between);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {2 * between, between});
  auto rows = control_rows(parameters, wanted_parameters(with));
  const bool none = rows.empty();
  if (!none) show_groups(context, with, std::move(rows), listed);
  ImGui::PopStyleVar();
  listed.seen = with.editing.shown().pose();
  if (!none) return;
  if (parameters.empty()) {
    ImGui::TextWrapped("This model has nothing to pose yet. Take the tool Rig and sketch a control.");
  } else {
    ImGui::TextWrapped(with.panels.own.of<ParameterList>().filter.empty() ? "Nothing has moved yet."
                                                                          : "No name matches.");
  }
}

}  // namespace

void show_parameters(PanelContext& context, EditingSession& editing, Controls& controls, Dialogs& dialogs,
                     PanelState& panels, Restriction& restriction) {
  const SidePanelOwners with{editing, controls, dialogs, panels, restriction};
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float moved = button_width(context, "Moved", {}, true);
  text_field(context, "##search", panels.own.of<ParameterList>().filter,
             ImGui::GetContentRegionAvail().x - context.unit - moved - 2 * spacing, "search");
  ImGui::SameLine();
  if (icon_button(context, "x##clear", {context.unit, false, "Show all", icon::k_cross, false})) {
    panels.own.of<ParameterList>().filter.clear();
    panels.own.of<ParameterList>().moved_only = false;
  }
  ImGui::SameLine();
  action_button(context, Action::moved_only, moved, panels.own.of<ParameterList>().moved_only, "Moved");
  begin_list(context, "list", {});
  holds_presses(context);
  show_list(context, with);
  ImGui::EndChild();
}

}  // namespace penpose::app
