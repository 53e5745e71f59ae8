#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/widgets/internal/widgets.h"

// The picture behind the model in hand: dragged on the canvas, sized by the wheel, with a row of what can be done.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct BackdropPanelOwners {
  Canvas& canvas;
};

constexpr double k_step = 1.08;
constexpr double k_backdrop_bar_units = 15;

/// Takes the canvas, so that what is dragged is the picture.
void take_canvas(PanelContext& context, const BackdropPanelOwners& with, Backdrop& backdrop, const Area& free) {
  ImGui::SetNextWindowBgAlpha(0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  if (begin_panel(context, "backdrop canvas", free)) {
    ImGui::InvisibleButton("backdrop drag", {static_cast<float>(free.width()), static_cast<float>(free.height())});
    const document::View& view = with.canvas.view();
    const ImGuiIO& io = ImGui::GetIO();
    const PxPoint at{static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y)};
    if (ImGui::IsItemActivated()) backdrop.held = at;
    // The last way before it was let go counts, too.
    if (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) {
      backdrop.drag(view, at - backdrop.held);
      backdrop.held = at;
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
      backdrop.enlarge(view, std::pow(k_step, static_cast<double>(io.MouseWheel)), at);
    }
  }
  end_panel();
  ImGui::PopStyleVar();
}

}  // namespace

void show_backdrop(PanelContext& context, const Area& free, Canvas& canvas, CanvasLook& look, Playback& playback,
                   Notices& notices, Dialogs& dialogs) {
  const BackdropPanelOwners with{canvas};
  const auto backdrop = look.backdrop;
  if (!backdrop) return;
  if (const auto shown = backdrop->show(playback.time_s(), playback.rate()); !shown)
    notices.tell(shown.error().line(backdrop->path()), true);
  if (!backdrop->adjusting || dialogs.open() != Dialog::none) return;
  const double unit = static_cast<double>(context.unit);
  const double gap = static_cast<double>(context.gap);
  const double wide = std::min(free.width(), k_backdrop_bar_units * unit);
  const Area bar{free.middle().x - 0.5 * wide, free.bottom - unit - 2 * gap, free.middle().x + 0.5 * wide, free.bottom};
  if (begin_panel(context, "backdrop bar", bar)) {
    const float each = static_cast<float>(wide) - 3 * context.gap;
    double opacity = backdrop->opacity;
    bool released = false;
    if (tall_slider(context, "##behind", opacity, 0, 1, 0.34F * each, "Shows", released)) backdrop->opacity = opacity;
    ImGui::SameLine();
    if (wide_button(context, "-##behind", context.unit, false, "Smaller; so does the wheel"))
      backdrop->enlarge(canvas.view(), 1 / k_step, free.middle());
    ImGui::SameLine();
    if (wide_button(context, "+##behind", context.unit, false, "Larger; so does the wheel"))
      backdrop->enlarge(canvas.view(), k_step, free.middle());
    ImGui::SameLine();
    if (wide_button(context, "Other##behind", 0, false, "Choose another picture")) {
      dialogs.show(Dialog::backdrop);
    }
    ImGui::SameLine();
    if (wide_button(context, "Remove##behind", 0, false, "Take the picture away")) look.backdrop.reset();
    ImGui::SameLine();
    if (primary_button(context, "Done##behind", -1, "Leave it there and draw")) backdrop->adjusting = false;
  }
  end_panel();
  // Of windows that never come to the front the one that was first lies above.
  take_canvas(context, with, *backdrop, free);
}

}  // namespace penpose::app
