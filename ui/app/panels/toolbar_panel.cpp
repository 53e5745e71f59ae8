#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/suggestion_offer.h"
#include "ui/app/tools/tool.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/widgets/internal/widgets.h"

// Tools, and what is done to all that is drawn.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct ToolbarPanelOwners {
  EditingSession& editing;
};

/// How much of what is drawn is taken for the hand and not for a wish: a press takes the next of three.
void show_hand_button(PanelContext& context, const ToolbarPanelOwners& with) {
  struct Hand {
    const char* label;
    double unsteadiness;
  };
  constexpr Hand k_hands[] = {{"Steady", 0.5}, {"Usual hand", 1.0}, {"Unsteady", 2.0}};
  const double now = with.editing.document().hand;
  std::size_t is = 0;
  while (is + 1 < std::size(k_hands) && k_hands[is].unsteadiness < now) ++is;
  const char* tip = "How steady the hand is: what a line strays by is not taken for a wish. Press for the next";
  if (wide_button(context, k_hands[is].label, -1, now != 1.0, tip))
    with.editing.perform(document::SetHand{k_hands[(is + 1) % std::size(k_hands)].unsteadiness});
}

}  // namespace

void show_toolbar(PanelContext& context, const Area& area, EditingSession& editing, SuggestionOffer& offer,
                  ToolInHand& tool) {
  const ToolbarPanelOwners with{editing};
  // A thin bar: the pen drags the tools themselves, and their names need the room.
  ImGui::PushStyleVar(ImGuiStyleVar_ScrollbarSize, context.gap);
  const bool shown = begin_panel(context, "tools", area, true);
  ImGui::PopStyleVar();
  if (shown) {
    for (const WindowTool& one : window_tools()) {
      if (one.button.label.empty()) continue;
      if (one.stands_apart) ImGui::Dummy({1, context.gap});
      action_button(context, {one.button.action}, -1, &one == &tool.now());
    }
    ImGui::Dummy({1, context.gap});
    action_button(context, Action::clear_curves, -1);
    action_button(context, Action::reset_pose, -1);
    show_suggest_button(context, editing, offer);
    const bool weighted = editing.document().pressure_weighting;
    if (wide_button(context, "Pressure", -1, weighted, "A target pulls harder where the pen pressed harder")) {
      editing.perform(document::SetPressureWeighting{!weighted});
    }
    show_hand_button(context, with);
  }
  end_panel();
}

}  // namespace penpose::app
