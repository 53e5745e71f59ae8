#include <array>
#include <optional>
#include <string>

#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// The panel at the right with its tabs. Closed it is a rail with a picture of each.

namespace penpose::app {
namespace {

struct SideTab {
  const char* label;
  const char* tip;
  std::string_view icon;
  bool PanelState::*part;  ///< null: none of the others
};
constexpr std::array<SideTab, 4> k_side_tabs{
    {{"Parameters", "All controls as sliders", "D9 7 2.4D15 12 2.4D8 17 2.4M4 7L20 7M4 12L20 12M4 17L20 17", nullptr},
     {"Controls", "Controls that you sketched, and new ones", "D4 15.5 2.2D20 15.5 2.2D12 9 2.2A12 17 8 190 350",
      &PanelState::controls_tab},
     {"Poses", "Keyed poses and the library", "C12 12 8.5D9 10 1.2D15 10 1.2A12 12 4.5 30 150", &PanelState::poses_tab},
     {"Mouths", "The mouths that speech is drawn with", "M3 12L8 8.5L12 10L16 8.5L21 12L16 16.5L8 16.5ZM3 12L21 12",
      &PanelState::mouths_tab}}};
/// Room beside the word of a tab, in targets of a pen.
constexpr float k_tab_pad = 0.44F;
constexpr std::string_view k_close_side = "M6 5L13 12L6 19M19 5L19 19";
constexpr std::string_view k_open_side = "M18 5L11 12L18 19M5 5L5 19";

bool is_chosen(const PanelState& panels, const SideTab& tab) {
  return tab.part != nullptr ? panels.*tab.part : !panels.controls_tab && !panels.poses_tab && !panels.mouths_tab;
}

void choose(PanelState& panels, const SideTab& tab) {
  panels.controls_tab = panels.poses_tab = panels.mouths_tab = false;
  if (tab.part != nullptr) panels.*tab.part = true;
}

void show_rail(PanelContext& context, PanelState& panels) {
  if (quiet_icon(context, "Open##side", k_open_side, "Open the side panel")) panels.open_side();
  for (const SideTab& tab : k_side_tabs) {
    if (!quiet_icon(context, tab.label, tab.icon, tab.tip)) continue;
    choose(panels, tab);
    panels.open_side();
  }
}

/// The tabs with their words where there is room for all of them, else as icons of equal width, which never move.
void show_tabs(PanelContext& context, PanelState& panels) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x - context.unit - 4 * spacing;
  float words = 0;
  for (const SideTab& tab : k_side_tabs) words += ImGui::CalcTextSize(tab.label).x + k_tab_pad * context.unit;
  const bool all = words <= room;
  const float pad = (room - words) / static_cast<float>(k_side_tabs.size());
  for (const SideTab& tab : k_side_tabs) {
    const bool chosen = is_chosen(panels, tab);
    ButtonLook look{ImGui::CalcTextSize(tab.label).x + k_tab_pad * context.unit + pad, chosen, tab.tip};
    if (!all) look = {room / static_cast<float>(k_side_tabs.size()), chosen, tab.tip, tab.icon, false};
    if (icon_button(context, tab.label, look)) choose(panels, tab);
    ImGui::SameLine();
  }
  if (quiet_icon(context, "Close##side", k_close_side, "Close the panel to a rail")) panels.open_side(false);
}

}  // namespace

void show_side_panel(PanelContext& context, const Area& area, EditingSession& editing, Canvas& canvas,
                     Controls& controls, Playback& playback, Notices& notices, KeptMouths& mouths, Dialogs& dialogs,
                     PanelState& panels, PoseShelf& shelf, Restriction& restriction) {
  if (begin_panel(context, "side", area, true)) {
    if (panels.controls_tab) panels.poses_tab = panels.mouths_tab = false;
    if (!panels.side_open()) {
      show_rail(context, panels);
    } else {
      show_tabs(context, panels);
      if (panels.mouths_tab) {
        show_mouths(context, editing, mouths, dialogs, panels);
      } else if (panels.poses_tab) {
        show_poses(context, editing, playback, panels, shelf);
      } else if (panels.controls_tab) {
        show_deformers(context, editing, canvas, controls, notices, dialogs, panels);
      } else {
        show_parameters(context, editing, controls, dialogs, panels, restriction);
      }
    }
  }
  end_panel();
}

}  // namespace penpose::app
