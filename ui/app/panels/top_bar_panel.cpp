#include "ui/app/canvas/canvas.h"
#include "ui/app/files/recording.h"
#include "ui/app/menu/menu_panel.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/preferences.h"
#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// The bar at the top, with the menu.

namespace penpose::app {

void show_top_bar(PanelContext& context, const Area& area, Canvas& canvas, CanvasLook& look, Playback& playback,
                  Recording& recording, Preferences& preferences) {
  if (begin_panel(context, "top", area)) {
    ButtonLook menu{0, false, "Everything that can be done, in sections", icon::k_menu};
    menu.weight = ButtonWeight::quiet;
    if (icon_button(context, "Menu", menu)) ImGui::OpenPopup("menu");
    show_menu(context, preferences, static_cast<float>(area.bottom));
    ImGui::SameLine();
    const float radius = 0.16F * context.unit;
    const ImVec2 middle{static_cast<float>(area.right) - 0.7F * context.unit, 0.5F * static_cast<float>(area.height())};
    ButtonRow row(context, "more views");
    // Icons that everybody knows stand alone.
    row.add(Action::undo, false, true, false);
    row.add(Action::redo, false, true, false);
    row.add(Action::history, false, true, false);
    row.separate();
    for (const Action action : {Action::view_front, Action::view_three_quarter, Action::view_side}) row.add(action);
    row.add(Action::frame_all, false, true, false);
    row.add(Action::flat_view, canvas.flat(), true, false);
    row.separate();
    row.add(Action::mirror_strokes, playback.while_drawing().mirrors);
    row.add(Action::wireframe, look.wireframe, true, false);
    if (canvas.surface().appearance().look) row.add(Action::clay, look.clay, true, false);
    row.add(Action{"matcap"}, look.matcap, true, false);
    row.separate();
    row.add(Action::search, false, true, false);
    row.add(Action::panels, false, true, false);
    row.show(ImGui::GetContentRegionAvail().x - 1.2F * context.unit);
    // The recording light.
    ImGui::GetWindowDrawList()->AddCircleFilled(middle, radius,
                                                color_of(recording.records() ? palette().record : palette().idle));
    ImGui::SetCursorScreenPos({middle.x - 0.5F * context.unit, middle.y - 0.5F * context.unit});
    ImGui::Dummy({context.unit, context.unit});
    tooltip(context, recording.records() ? ("Recorded as it happens: " + recording.path()).c_str()
                                         : "This session is not being recorded");
  }
  end_panel();
}

}  // namespace penpose::app
