#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// An end of the bar in hand.
struct ReachDrag {
  bool held = false;
  bool to = false;
  double at_s = 0;
};

/// The bar as it is shown, also while an end of it is dragged.
std::pair<double, double> shown_reach(const TimelineOwners& with) {
  const ReachDrag& drag = with.panels.own.of<ReachDrag>();
  const GhostEdit& edit = *with.ghosts.last();
  if (!drag.held) return {edit.from_s, edit.to_s};
  if (drag.to) return {edit.from_s, std::max(drag.at_s, edit.time_s)};
  return {std::min(drag.at_s, edit.time_s), edit.to_s};
}

}  // namespace

void hit_ghost_reach(PanelContext& context, const TimelineOwners& with) {
  ReachDrag& drag = with.panels.own.of<ReachDrag>();
  if (with.ghosts.last() == nullptr) {
    drag = {};
    return;
  }
  const ImVec2 corner = ImGui::GetCursorPos();
  const Strip strip = place_strip(context, with, 0);
  const float half = 0.5F * context.unit;
  const auto [from_s, to_s] = shown_reach(with);
  // Where both lie together they are side by side.
  const float between = 0.5F * (strip.x_of(from_s) + strip.x_of(to_s));
  for (const bool to : {false, true}) {
    const float end = strip.x_of(to ? to_s : from_s);
    const float x = to ? std::max(end, between + half) : std::min(end, between - half);
    ImGui::SetCursorScreenPos({x - half, strip.from.y});
    ImGui::InvisibleButton(to ? "reach to" : "reach", {2 * half, strip.size.y});
    note(context, to ? "reach to" : "reach");
    tooltip(context, "How far the change of the ghost goes: drag an end of the bar");
    const bool released = ImGui::IsItemDeactivated();
    if (ImGui::IsItemActive() || released)
      drag = {true, to, on_frame(strip.time_of(ImGui::GetIO().MousePos.x), with.playback.rate())};
    if (!released) continue;
    const auto [first_s, last_s] = shown_reach(with);
    drag = {};
    with.ghosts.reach(first_s, last_s);
    break;
  }
  ImGui::SetCursorPos(corner);
}

void draw_ghost_reach(const TimelineOwners& with, const Strip& strip) {
  if (with.ghosts.last() == nullptr) return;
  const auto [from_s, to_s] = shown_reach(with);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 top{strip.x_of(with.ghosts.last()->time_s), strip.from.y + scaled(2)};
  const float foot = strip.to().y - scaled(2);
  // As much of the change as is left: all of it at its moment, nothing at the ends.
  list.AddTriangleFilled({strip.x_of(from_s), foot}, top, {strip.x_of(to_s), foot},
                         ImGui::GetColorU32(ImGuiCol_ButtonActive, 0.35F));
  for (const double end_s : {from_s, to_s}) {
    const float x = strip.x_of(end_s);
    list.AddRectFilled({x - scaled(3), strip.from.y}, {x + scaled(3), strip.to().y},
                       ImGui::GetColorU32(ImGuiCol_ButtonActive), scaled(3));
  }
}

}  // namespace penpose::app
