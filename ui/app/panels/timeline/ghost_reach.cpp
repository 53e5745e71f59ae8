#include <algorithm>
#include <cmath>

#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// An end of the bar in hand.
struct ReachDrag {
  bool held = false;
  bool to = false;
  double at_s = 0;
};

}  // namespace

void show_ghost_reach(PanelContext& context, const TimelineOwners& with) {
  ReachDrag& drag = with.panels.own.of<ReachDrag>();
  if (with.ghosts.last() == nullptr) {
    drag = {};
    return;
  }
  const GhostEdit edit = *with.ghosts.last();
  const int rate = with.playback.rate();
  const Strip strip = begin_strip(context, with, "reach",
                                  "How far the change of the ghost goes: drag an end of the bar", 0.6F * context.unit);
  const double pointer_s = on_frame(strip.time_of(ImGui::GetIO().MousePos.x), rate);
  if (ImGui::IsItemActivated()) {
    drag.held = true;
    drag.to = std::abs(pointer_s - edit.to_s) < std::abs(pointer_s - edit.from_s);
    // Where both lie together, the side says which is meant.
    if (edit.from_s == edit.to_s || pointer_s > edit.to_s || pointer_s < edit.from_s) drag.to = pointer_s > edit.time_s;
  }
  const bool released = ImGui::IsItemDeactivated();
  if (ImGui::IsItemActive() || released) drag.at_s = pointer_s;
  double from_s = edit.from_s;
  double to_s = edit.to_s;
  if (drag.held) {
    if (drag.to) {
      to_s = std::max(drag.at_s, edit.time_s);
    } else {
      from_s = std::min(drag.at_s, edit.time_s);
    }
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(strip.from, strip.to(), true);
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_ButtonActive);
  const float y = strip.from.y + 0.5F * strip.size.y;
  const ImVec2 from{strip.x_of(from_s), y};
  const ImVec2 to{strip.x_of(to_s), y};
  const ImVec2 top{strip.x_of(edit.time_s), strip.from.y + 2};
  // As much of the change as is left: all of it at its moment, nothing at the ends.
  list.AddTriangleFilled({from.x, strip.to().y - 2}, top, {to.x, strip.to().y - 2},
                         ImGui::GetColorU32(ImGuiCol_ButtonActive, 0.5F));
  for (const ImVec2& end : {from, to})
    list.AddRectFilled({end.x - 3, strip.from.y}, {end.x + 3, strip.to().y}, color, 3);
  list.PopClipRect();
  if (!released) return;
  drag.held = false;
  with.ghosts.reach(from_s, to_s);
}

}  // namespace penpose::app
