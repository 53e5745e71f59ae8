#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/view/outcome.h"
#include "ui/app/view/shown_curves.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"
#include "ui/render/ghosts/ghost_drawings.h"
#include "ui/render/scene.h"

// What there is to say of the canvas: what came of the last stroke, else what the tool in hand does, and what colours
// mean.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct StatusPanelOwners {
  EditingSession& editing;
  CanvasLook& look;
};

ImU32 display(const render::Color& color) {
  const auto byte = [](float value) { return static_cast<int>(255 * render::encode_srgb(value) + 0.5F); };
  return IM_COL32(byte(color.r), byte(color.g), byte(color.b), 255);
}

/// Colours that are on the canvas now, with what they mean.
std::vector<std::pair<ImU32, const char*>> legend(const StatusPanelOwners& with) {
  using render::CurveKind;
  std::vector<std::pair<ImU32, const char*>> out;
  const document::Document& document = with.editing.document();
  const CurveMoments& moments = with.editing.moments();
  const auto any = [&](const auto& is) {
    return std::any_of(document.curves.begin(), document.curves.end(),
                       [&](const auto& curve) { return moments.shows(curve->id) && is(curve); });
  };
  const bool held = any([](const auto& c) { return c->role == document::PoseCurveRole::constraint; });
  const bool drawn = any([](const auto& c) { return c->role == document::PoseCurveRole::reference; });
  const bool wanted = any([](const auto& c) { return c->target.has_value(); });
  if (drawn) out.emplace_back(display(render::curve_color(CurveKind::reference)), "is");
  if (wanted) out.emplace_back(display(render::curve_color(CurveKind::target)), "should be");
  if (wanted) out.emplace_back(display(distance_color(1, 1)), "missed");
  if (held) out.emplace_back(display(render::curve_color(CurveKind::constraint)), "stays");
  if (with.look.onion_skin && moments.any() && !document.timeline->keys.empty()) {
    out.emplace_back(display(render::from_srgb(render::k_before_color)), "before");
    out.emplace_back(display(render::from_srgb(render::k_after_color)), "after");
  }
  return out;
}

/// At the right end of a line; where it begins.
float show_legend(const StatusPanelOwners& with, const Area& area, float gap) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const auto middle = static_cast<float>(area.middle().y);
  auto x = static_cast<float>(area.right) - gap;
  const auto all = legend(with);
  for (auto it = all.rbegin(); it != all.rend(); ++it) {
    const ImVec2 size = ImGui::CalcTextSize(it->second);
    const float dot = 0.3F * size.y;
    if (x - size.x - 4 * dot - gap < static_cast<float>(area.left + 0.5 * area.width())) break;
    x -= size.x;
    list.AddText({x, middle - 0.5F * size.y}, ink, it->second);
    x -= 2 * dot;
    list.AddCircleFilled({x, middle}, dot, it->first);
    x -= dot + 2 * gap;
  }
  return x;
}

}  // namespace

void show_status(PanelContext& context, const Area& area, EditingSession& editing, CanvasLook& look, ToolInHand& tool) {
  const StatusPanelOwners with{editing, look};
  if (begin_panel(context, "status", area)) {
    ImGui::PushFont(small_font());
    const float end = show_legend(with, area, context.gap);
    std::string text = outcome_of(editing);
    const bool hints = text.empty();
    if (hints) text = tool.hint();
    if (!text.empty()) {
      const auto x = static_cast<float>(area.left) + context.gap;
      const auto y = static_cast<float>(area.middle().y) - 0.5F * ImGui::GetFontSize();
      const std::string shown = fitted_text(text, end - x - context.gap);
      ImGui::GetWindowDrawList()->AddText({x, y}, ImGui::GetColorU32(hints ? ImGuiCol_TextDisabled : ImGuiCol_Text),
                                          shown.c_str());
      ImGui::SetCursorScreenPos({x, static_cast<float>(area.top)});
      ImGui::Dummy({std::max(1.0F, end - x), static_cast<float>(area.height())});
      tooltip(context, text.c_str());
    }
    ImGui::PopFont();
  }
  end_panel();
}

}  // namespace penpose::app
