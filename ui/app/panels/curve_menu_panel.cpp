#include <algorithm>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"

// What can be done with a curve that was touched, beside it.

namespace penpose::app {

void show_curve_menu(PanelContext& context, const Area& /*area*/, EditingSession& editing, Canvas& canvas,
                     PanelState& panels) {
  const auto chosen = panels.curve_menu;
  const auto* curve = chosen ? document::find_curve(editing.document(), chosen->first) : nullptr;
  if (curve == nullptr || editing.editor().tool().kind != drawing::ToolKind::none) {
    panels.curve_menu.reset();
    return;
  }
  const bool reference = curve->role == document::PoseCurveRole::reference;
  const float width = 3 * context.unit;
  const double rows = 1 + (reference ? 1 : 0) + (curve->target ? 1 : 0);
  const double height = rows * (context.unit + static_cast<double>(ImGui::GetStyle().ItemSpacing.y)) + context.gap;
  const double wide = static_cast<double>(width) + 2 * context.gap;
  const Area free = canvas.free_area();
  const double left = std::clamp(chosen->second.x + context.unit, free.left, std::max(free.left, free.right - wide));
  const double top = std::clamp(chosen->second.y, free.top, std::max(free.top, free.bottom - height));
  const document::CurveId id = curve->id;
  const bool target = curve->target.has_value();
  bool done = false;
  if (begin_panel(context, "curve", {left, top, left + wide, top + height})) {
    if (target && wide_button(context, "Redraw##curve", -1, false, "Draw over a part of this target")) {
      drawing::Tool tool;
      tool.kind = drawing::ToolKind::oversketch;
      tool.curve = id;
      editing.set_tool(tool);
      done = true;
    }
    if (reference && wide_button(context, "Keep##curve", -1, false, tooltip_of(Action::keep_curve).c_str())) {
      editing.perform(document::KeepCurve{id});
      done = true;
    }
    if (wide_button(context, "Delete##curve", -1, false, tooltip_of(Action::delete_curve).c_str())) {
      editing.perform(document::DeleteCurve{id});
      done = true;
    }
  }
  end_panel();
  if (done) panels.curve_menu.reset();
}

}  // namespace penpose::app
