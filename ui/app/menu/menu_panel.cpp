#include "ui/app/menu/menu_panel.h"

#include <algorithm>
#include <cfloat>

#include "ui/app/menu/menu_sections.h"
#include "ui/app/preferences.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// The menu: its sections at the left, what is in the one that was touched last beside them.

namespace penpose::app {
namespace {

constexpr float k_sections_units = 4.2F, k_entry_units = 7.6F;

/// What was touched last.
struct MenuShown {
  std::size_t section = 0;
};

/// The words of an action in the menu.
std::string entry_label(Action action, const Preferences& preferences) {
  if (action == Action::theme) return preferences.settings().light ? "Dark colours" : "Light colours";
  return std::string(info(action).label);
}

/// Rows that entries and the lines between their groups take, px from above.
struct MenuPlace {
  Action action;
  bool first_of_group = false;
};

std::vector<MenuPlace> places_of(const PanelContext& context, const MenuSection& section) {
  std::vector<MenuPlace> out;
  for (const auto& group : section.groups) {
    bool first = !out.empty();
    for (const Action action : group) {
      // These are for some files and some machines alone.
      const bool optional =
          action == Action::up_axis || action == Action::left_handed || action == Action{"screen_keyboard"};
      if (optional && !context.actions.usable(action)) continue;
      out.push_back({action, std::exchange(first, false)});
    }
  }
  return out;
}

void show_entry(PanelContext& context, const Preferences& preferences, Action action, float width) {
  const std::string label = entry_label(action, preferences);
  const std::string key = context.actions.keys().shortcut_of(action);
  const std::string tip(info(action).tip);
  ButtonLook look{width, false, tip.c_str(), icon_of(action), true, true, key, ButtonWeight::quiet};
  const float wide = button_width(context, label.c_str(), look.icon, true) + ImGui::CalcTextSize(key.c_str()).x;
  if (wide > width) look.key = {};
  ImGui::BeginDisabled(!context.actions.usable(action));
  const bool pressed = icon_button(context, label.c_str(), look);
  ImGui::EndDisabled();
  if (!pressed) return;
  ImGui::CloseCurrentPopup();
  context.actions.run(action);
}

/// Where columns begin: between groups as long as none is higher than `fit` rows nor one more than `most`, else evenly.
std::vector<std::size_t> columns_of(const std::vector<MenuPlace>& places, std::size_t fit, std::size_t most) {
  std::vector<std::size_t> columns{0};
  std::size_t group = 0;
  bool too_long = false;
  for (std::size_t i = 1; i <= places.size(); ++i) {
    if (i < places.size() && !places[i].first_of_group) continue;
    if (i - columns.back() > fit) {
      if (group > columns.back()) columns.push_back(group);
      too_long = too_long || i - columns.back() > fit;
    }
    group = i;
  }
  if (columns.size() <= most && !too_long) return columns;
  const std::size_t count = std::clamp<std::size_t>((places.size() + fit - 1) / fit, 1, most);
  const std::size_t rows = (places.size() + count - 1) / count;
  columns.clear();
  for (std::size_t from = 0; from < places.size(); from += rows) columns.push_back(from);
  return columns;
}

/// Entries in columns, each as high as there is room; a line between groups, none at a column's head.
void show_entries(PanelContext& context, const Preferences& preferences, const std::vector<MenuPlace>& places,
                  const std::vector<std::size_t>& columns) {
  const float width = k_entry_units * context.unit;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const std::size_t from = columns[column];
    const std::size_t to = column + 1 < columns.size() ? columns[column + 1] : places.size();
    if (column > 0) ImGui::SameLine();
    ImGui::BeginGroup();
    for (std::size_t i = from; i < to; ++i) {
      if (places[i].first_of_group && i > from) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float y = at.y - 0.5F * ImGui::GetStyle().ItemSpacing.y;
        ImGui::GetWindowDrawList()->AddLine({at.x, y}, {at.x + width, y}, ImGui::GetColorU32(ImGuiCol_Separator));
      }
      show_entry(context, preferences, places[i].action, width);
    }
    ImGui::EndGroup();
  }
}

void show_sections(PanelContext& context, std::size_t& shown) {
  const auto& all = menu_sections();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string label = std::string(all[i].name) + "##section";
    const ButtonLook look{
        k_sections_units * context.unit, i == shown, nullptr, all[i].icon, true, true, {}, ButtonWeight::quiet};
    if (icon_button(context, label.c_str(), look)) shown = i;
  }
}

}  // namespace

void show_menu(PanelContext& context, const Preferences& preferences, float top) {
  const auto window_width = static_cast<float>(context.window.width);
  const float height = std::max(static_cast<float>(context.window.height) - top, 3 * context.unit);
  ImGui::SetNextWindowPos({context.gap, top});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {window_width - 2 * context.gap, height});
  // A menu may reach over the canvas: while it is open nothing else is hit.
  if (!begin_menu(context, "menu")) return;
  const ImGuiStyle& style = ImGui::GetStyle();
  auto& shown = context.own.of<MenuShown>().section;
  ImGui::BeginGroup();
  show_sections(context, shown);
  ImGui::EndGroup();
  ImGui::SameLine(0, 2 * style.ItemSpacing.x);
  const auto places = places_of(context, menu_sections()[shown]);
  const float row = context.unit + style.ItemSpacing.y;
  const float column = k_entry_units * context.unit + style.ItemSpacing.x;
  const float room = window_width - 2 * context.gap - 2 * style.WindowPadding.x - style.ScrollbarSize -
                     k_sections_units * context.unit - 2 * style.ItemSpacing.x;
  const auto fit = static_cast<std::size_t>(std::max(1.0F, (height - 2 * style.WindowPadding.y) / row));
  const auto most = static_cast<std::size_t>(std::max(1.0F, (room + style.ItemSpacing.x) / column));
  ImGui::BeginGroup();
  show_entries(context, preferences, places, columns_of(places, fit, most));
  ImGui::EndGroup();
  ImGui::EndPopup();
}

}  // namespace penpose::app
