#include <algorithm>
#include <cfloat>
#include <initializer_list>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/files/recording.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/preferences.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// The bar at the top, with the menu.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct TopBarPanelOwners {
  Canvas& canvas;
  Preferences& preferences;
  Dialogs& dialogs;
  PanelState& panels;
};

/// A line between two groups of a menu's column.
void rule(const PanelContext& context) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = menu_column(context);
  ImGui::GetWindowDrawList()->AddLine(from, {from.x + width, from.y}, ImGui::GetColorU32(ImGuiCol_Separator));
  ImGui::Dummy({width, 1});
}

/// All that is neither a tool nor of the timeline, in groups.
void show_menu(PanelContext& context, const TopBarPanelOwners& with, const Area& bar) {
  const float below = static_cast<float>(with.canvas.window().height - bar.bottom);
  ImGui::SetNextWindowPos({context.gap, static_cast<float>(bar.bottom)});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, std::max(below, 3 * context.unit)});
  // A menu may reach over the canvas: while it is open nothing else is hit.
  if (!begin_menu(context, "menu")) return;
  const auto entry = [&](const char* label, std::string_view drawn, const char* tip) {
    const bool pressed = menu_entry(context, label, drawn, {}, tip);
    if (pressed) ImGui::CloseCurrentPopup();
    return pressed;
  };
  const auto actions = [&](std::initializer_list<Action> group) {
    for (const Action action : group) {
      const std::string label = action == Action::theme
                                    ? with.preferences.settings().light ? "Dark colours" : "Light colours"
                                    : std::string(info(action).label);
      const std::string key = context.actions.keys().shortcut_of(action);
      if (!menu_entry(context, label.c_str(), icon_of(action), key, std::string(info(action).tip).c_str())) continue;
      ImGui::CloseCurrentPopup();
      context.actions.run(action);
    }
  };
  // Two columns, so that it ends above the window's foot.
  ImGui::BeginGroup();
  actions({Action::open, Action::recent, Action::save, Action::save_as, Action::export_as, Action::film,
           Action{"playblast"}, Action::backdrop, Action{"sound"}});
  if (context.actions.usable(Action::up_axis)) actions({Action::up_axis, Action::left_handed});
  if (entry("Sessions", icon::k_session, "What was drawn before, to play or to go on with")) {
    with.dialogs.show(Dialog::sessions);
  }
  rule(context);
  actions({Action::set_front, Action::history, Action::library, Action{"mouths"}, Action::flip_pose,
           Action::copy_to_right, Action::copy_to_left, Action::neutral});
  ImGui::EndGroup();
  ImGui::SameLine();
  ImGui::BeginGroup();
  actions({Action{"preferences"}, Action::stabiliser, Action::density, Action::theme, Action::larger, Action::smaller,
           Action::fullscreen});
  rule(context);
  if (entry("Tablet", icon::k_tablet, "The area and the pressure of the tablet")) with.dialogs.show(Dialog::tablet);
  if (entry("Tablet keys", icon::k_keys, "What the keys and rings of the tablet and the pen's buttons do"))
    with.dialogs.show(Dialog::pad);
  if (entry("Pen menu", icon::k_radial, "What the menu around the pen offers")) with.dialogs.show(Dialog::radial);
  if (with.panels.has_keyboard &&
      entry("Screen keyboard", icon_of(Action::shortcuts), "Show keys on the screen while a name is typed")) {
    with.panels.has_keyboard = false;
  }
  rule(context);
  actions({Action::search, Action::shortcuts, Action::help, Action::quit});
  ImGui::EndGroup();
  ImGui::EndPopup();
}

}  // namespace

void show_top_bar(PanelContext& context, const Area& area, Canvas& canvas, CanvasLook& look, Playback& playback,
                  ToolInHand& tool, Recording& recording, Preferences& preferences, Dialogs& dialogs,
                  PanelState& panels) {
  const TopBarPanelOwners with{canvas, preferences, dialogs, panels};
  if (begin_panel(context, "top", area)) {
    if (icon_button(context, "Menu", {0, false, "Files, settings and sessions", icon::k_menu})) {
      ImGui::OpenPopup("menu");
    }
    show_menu(context, with, area);
    ImGui::SameLine();
    const float radius = 0.16F * context.unit;
    const ImVec2 middle{static_cast<float>(area.right) - 0.7F * context.unit, 0.5F * static_cast<float>(area.height())};
    ButtonRow row(context, "more views");
    // Icons that everybody knows stand alone.
    row.add(Action::undo, false, true, false);
    row.add(Action::redo, false, true, false);
    row.add(Action::history, false, true, false);
    for (const Action action : {Action::view_front, Action::view_three_quarter, Action::view_side}) row.add(action);
    row.add(Action::frame_all, false, true, false);
    row.add(Action::flat_view, canvas.flat(), true, false);
    row.add(Action::mirror_strokes, playback.while_drawing().mirrors);
    row.add(Action::search, false, true, false);
    row.add(Action::wireframe, look.wireframe, true, false);
    if (canvas.surface().appearance().look) row.add(Action::clay, look.clay, true, false);
    row.add(Action::panels);
    // What to do next is worth a third of the bar.
    const float room = ImGui::GetContentRegionAvail().x - 1.2F * context.unit;
    row.show(room - std::min(0.3F * room, ImGui::CalcTextSize(tool.hint().c_str()).x + 3 * context.gap));
    ImGui::SameLine();
    text_line(context, tool.hint(), middle.x - 2 * radius - ImGui::GetCursorScreenPos().x,
              ImGui::GetColorU32(ImGuiCol_Text));
    tooltip(context, tool.hint().c_str());
    // The recording light.
    ImGui::GetWindowDrawList()->AddCircleFilled(middle, radius,
                                                color_of(recording.records() ? palette().record : palette().idle));
    ImGui::SetCursorScreenPos({middle.x - 0.5F * context.unit, middle.y - 0.5F * context.unit});
    ImGui::Dummy({context.unit, context.unit});
    tooltip(context, recording.records() ? ("Recorded as it happens: " + recording.path()).c_str()
                                         : "This session is not recorded");
  }
  end_panel();
}

}  // namespace penpose::app
