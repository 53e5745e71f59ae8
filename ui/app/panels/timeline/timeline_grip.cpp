#include <algorithm>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/preferences.h"
#include "ui/app/widgets/internal/widgets.h"

// The upper edge of the timeline: dragged, it makes the sheet or the curves higher or lower.

namespace penpose::app {
namespace {

constexpr double k_least_grip_px = 32;  ///< at scale 1

/// Begins a window without a ground that lies over the panels below it.
bool begin_grip(PanelContext& context, const Area& area) {
  ImGui::SetNextWindowPos({static_cast<float>(area.left), static_cast<float>(area.top)});
  ImGui::SetNextWindowSize({static_cast<float>(area.width()), static_cast<float>(area.height())});
  context.hits.panels.push_back(area);
  return ImGui::Begin("timeline grip", nullptr,
                      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                          ImGuiWindowFlags_NoNav);
}

/// The edge in hand.
struct GripDrag {
  bool held = false;
  double height = 0;  ///< px of the rows when it was taken
  double from_y = 0;
};

}  // namespace

void show_timeline_grip(PanelContext& context, const Area& area, Canvas& canvas, Preferences& preferences,
                        PanelState& panels) {
  const TimelineShown& shown = panels.own.of<TimelineShown>();
  if (shown.part == TimelinePart::poses || shown.rows_px <= 0) return;
  GripDrag& drag = panels.own.of<GripDrag>();
  const double scale = canvas.scale();
  // Mostly over the line of status, which takes no pen.
  const double high = k_least_grip_px * scale;
  const double inside = static_cast<double>(context.gap);
  const Area place{context.free.left, area.top + inside - high, context.free.right, area.top + inside};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  if (begin_grip(context, place)) {
    ImGui::InvisibleButton("##grip", {static_cast<float>(place.width()), static_cast<float>(place.height())});
    note(context, "timeline grip");
    tooltip(context, "Drag to make the rows higher or lower; it is kept");
    const auto y = static_cast<double>(ImGui::GetIO().MousePos.y);
    if (ImGui::IsItemActivated()) drag = {true, shown.rows_px, y};
    double& height =
        shown.part == TimelinePart::sheet ? preferences.settings().sheet_height : preferences.settings().curves_height;
    if (ImGui::IsItemActive() && y != drag.from_y)
      height = std::clamp((drag.height + drag.from_y - y) / scale, k_least_rows_px, k_most_rows_px);
    if (ImGui::IsItemDeactivated()) {
      // No more than there is room for.
      if (y != drag.from_y) height = std::clamp(shown.rows_px / scale, k_least_rows_px, k_most_rows_px);
      drag = {};
      preferences.changed();
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    const float edge = static_cast<float>(place.bottom) - context.gap;
    const auto middle = static_cast<float>(0.5 * (place.left + place.right));
    const ImU32 color = ImGui::GetColorU32(lit ? ImGuiCol_ButtonActive : ImGuiCol_TextDisabled, lit ? 1.0F : 0.7F);
    list.AddRectFilled({middle - 0.9F * context.unit, edge - 2}, {middle + 0.9F * context.unit, edge + 2}, color, 2);
    if (lit) list.AddLine({static_cast<float>(place.left), edge}, {static_cast<float>(place.right), edge}, color, 1);
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace penpose::app
