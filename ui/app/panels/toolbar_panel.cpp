#include <algorithm>
#include <array>
#include <vector>

#include "ui/app/hand_actions.h"
#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/suggestion_offer.h"
#include "ui/app/tools/tool.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// Tools, and what is done to all that is drawn.

namespace penpose::app {
namespace {

constexpr int k_most_tools_across = 3;
/// What stands below the tools.
constexpr std::array k_below_tools{Action::clear_curves, Action::reset_pose, Action::suggest_rest, Action{"pressure"},
                                   Action{"hand"}};

/// Those that place characters stand beside their names.
bool stands_here(const WindowTool& tool) { return !tool.button.label.empty() && !tool.places; }

/// How many buttons stand in each group.
std::vector<int> tool_groups() {
  std::vector<int> groups{0};
  for (const WindowTool& one : window_tools()) {
    if (!stands_here(one)) continue;
    if (one.stands_apart) groups.push_back(0);
    ++groups.back();
  }
  groups.push_back(static_cast<int>(k_below_tools.size()));
  return groups;
}

/// Px between two tools, one above the other: most have no ground.
float tool_spacing() { return scaled(2); }

float toolbar_height(const PanelContext& context, int across) {
  const auto groups = tool_groups();
  const float spacing = tool_spacing();
  float height = 2 * ImGui::GetStyle().WindowPadding.y;
  for (const int count : groups) height += static_cast<float>((count + across - 1) / across) * (context.unit + spacing);
  return height + static_cast<float>(groups.size() - 1) * (context.gap + spacing) - spacing;
}

/// The widest of all words with their icons, whatever is in hand.
float words_width(const PanelContext& context) {
  float widest = 0;
  const auto add = [&](std::string_view label, Action action) {
    widest = std::max(widest, button_width(context, std::string(label).c_str(), icon_of(action), true));
  };
  for (const WindowTool& one : window_tools()) {
    if (stands_here(one)) add(one.button.label, {one.button.action});
  }
  for (const Action action : k_below_tools) add(info(action).label, action);
  for (const double unsteadiness : {0.5, 1.0, 2.0}) add(steadiness_words(unsteadiness), Action{"hand"});
  return widest;
}

/// Puts buttons one beside the other, group by group.
class ToolGrid {
 public:
  ToolGrid(const PanelContext& context, const ToolbarLayout& layout) : gap_(context.gap), layout_(layout) {
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const auto across = static_cast<float>(layout.across);
    width_ = std::max(context.unit, (ImGui::GetContentRegionAvail().x - (across - 1) * spacing) / across);
  }
  void begin_group() {
    ImGui::Dummy({1, gap_});
    at_ = 0;
  }
  /// Makes room for the next button.
  float next() {
    if (at_++ % layout_.across != 0) ImGui::SameLine();
    return width_;
  }

 private:
  float gap_;
  const ToolbarLayout& layout_;
  float width_ = 0;
  int at_ = 0;
};

void show_tools(PanelContext& context, const ToolbarLayout& layout, EditingSession& editing, SuggestionOffer& offer,
                const ToolInHand& tool) {
  ToolGrid grid(context, layout);
  for (const WindowTool& one : window_tools()) {
    if (!stands_here(one)) continue;
    if (one.stands_apart) grid.begin_group();
    const bool in_hand = &one == &tool.now();
    tool_button(context, {one.button.action}, grid.next(), layout.words, in_hand,
                in_hand ? ButtonWeight::primary : ButtonWeight::quiet);
  }
  grid.begin_group();
  tool_button(context, Action::clear_curves, grid.next(), layout.words);
  tool_button(context, Action::reset_pose, grid.next(), layout.words);
  show_suggest_button(context, editing, offer, grid.next(), layout.words);
  tool_button(context, Action{"pressure"}, grid.next(), layout.words, editing.document().pressure_weighting);
  const double hand = editing.document().hand;
  tool_button(context, Action{"hand"}, grid.next(), layout.words, hand != 1.0, ButtonWeight::quiet,
              steadiness_words(hand));
}

}  // namespace

ToolbarLayout toolbar_layout(const PanelContext& context, float height) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float padding = 2 * style.WindowPadding.x;
  ToolbarLayout layout{true, 1, words_width(context) + padding};
  if (toolbar_height(context, 1) <= height) return layout;
  layout.words = false;
  do {
    ++layout.across;
  } while (layout.across < k_most_tools_across && toolbar_height(context, layout.across) > height);
  const auto across = static_cast<float>(layout.across);
  layout.width = across * context.unit + (across - 1) * style.ItemSpacing.x + padding;
  // Where not even these have room, a thin bar says that there are more.
  if (toolbar_height(context, layout.across) > height) layout.width += context.gap;
  return layout;
}

void show_toolbar(PanelContext& context, const Area& area, EditingSession& editing, SuggestionOffer& offer,
                  ToolInHand& tool) {
  // A thin bar: the pen drags the tools themselves.
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, context.gap);
  const bool shown = begin_panel(context, "tools", area, true);
  ImGui::PopStyleVar();
  if (shown) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, tool_spacing()});
    show_tools(context, context.own.of<ToolbarLayout>(), editing, offer, tool);
    ImGui::PopStyleVar();
  }
  end_panel();
}

}  // namespace penpose::app
