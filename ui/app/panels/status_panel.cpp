#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "ui/app/panels/panels.h"
#include "ui/app/view/outcome.h"
#include "ui/app/view/toast_place.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"
#include "ui/render/scene.h"

// What there is to say: what came of the last stroke, what colours mean, and what passes.

namespace penpose::app {
namespace {

ImU32 display(const render::Color& color) {
  const auto byte = [](float value) { return static_cast<int>(255 * render::encode_srgb(value) + 0.5F); };
  return IM_COL32(byte(color.r), byte(color.g), byte(color.b), 255);
}

/// Colours that are on the canvas now, with what they mean.
std::vector<std::pair<ImU32, const char*>> legend(App& app) {
  using render::CurveKind;
  std::vector<std::pair<ImU32, const char*>> out;
  const document::Document& document = app.editing().document();
  const auto any = [&](const auto& is) { return std::any_of(document.curves.begin(), document.curves.end(), is); };
  const bool held = any([](const auto& c) { return c->role == document::PoseCurveRole::constraint; });
  const bool drawn = any([](const auto& c) { return c->role == document::PoseCurveRole::reference; });
  const bool wanted = any([](const auto& c) { return c->target.has_value(); });
  if (drawn) out.emplace_back(display(render::curve_color(CurveKind::reference)), "is");
  if (wanted) out.emplace_back(display(render::curve_color(CurveKind::target)), "should be");
  if (wanted) out.emplace_back(display(distance_color(1, 1)), "missed");
  if (held) out.emplace_back(display(render::curve_color(CurveKind::constraint)), "stays");
  if (app.canvas().look().onion_skin && !document.timeline->keys.empty()) {
    out.emplace_back(display(render::from_srgb(k_before_color)), "key before");
    out.emplace_back(display(render::from_srgb(k_after_color)), "after");
  }
  return out;
}

/// At the right end of a line; where it begins.
float show_legend(App& app, const Area& area, float gap) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const auto middle = static_cast<float>(area.middle().y);
  auto x = static_cast<float>(area.right) - gap;
  const auto all = legend(app);
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

void show_status(PanelContext& context, const Area& area) {
  if (begin_panel(context, "status", area)) {
    ImGui::PushFont(small_font());
    const float end = show_legend(context.app, area, context.gap);
    const std::string text = outcome_of(context.app.editing());
    if (!text.empty()) {
      const auto x = static_cast<float>(area.left) + context.gap;
      const auto y = static_cast<float>(area.middle().y) - 0.5F * ImGui::GetFontSize();
      const std::string shown = fitted_text(text, end - x - context.gap);
      ImGui::GetWindowDrawList()->AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
      ImGui::SetCursorScreenPos({x, static_cast<float>(area.top)});
      ImGui::Dummy({std::max(1.0F, end - x), static_cast<float>(area.height())});
      tooltip(context, text.c_str());
    }
    ImGui::PopFont();
  }
  end_panel();
}

void show_notices(PanelContext& context) {
  const auto& notices = context.app.notices().all();
  if (notices.empty()) return;
  const Area free = context.app.canvas().free_area();
  // What a dialog has to tell is not to lie in its shade.
  const bool dialog = context.app.dialogs().open() != Dialog::none;
  ImDrawList& list = dialog ? *ImGui::GetForegroundDrawList() : *ImGui::GetBackgroundDrawList();
  const bool light = context.app.preferences().settings().light;
  const float pad = context.gap;
  const float width = std::min(static_cast<float>(free.width()) - 2 * context.gap, 20 * context.unit);
  float wide = 0;
  float high = 0;
  for (const Notice& one : notices) {
    const ImVec2 size = ImGui::CalcTextSize(one.text.c_str(), nullptr, false, width - 3 * pad);
    wide = std::max(wide, size.x + 3 * pad);
    high += size.y + 3 * pad;
  }
  const Area inner{free.left + static_cast<double>(pad), free.top + static_cast<double>(pad),
                   free.right - static_cast<double>(pad), free.bottom - static_cast<double>(pad)};
  const Area place = toast_place(inner, static_cast<double>(wide), static_cast<double>(high), drawn_px(context.app));
  auto y = static_cast<float>(place.top);
  const auto x = static_cast<float>(place.left);
  for (const Notice& one : notices) {
    // It goes as it came, and not at a stroke.
    const double left_s = static_cast<double>(one.until_us - context.app.options().clock()) * 1e-6;
    const int alpha = static_cast<int>(255 * std::clamp(left_s / k_fade_s, 0.0, 1.0));
    const ImU32 back = light ? IM_COL32(255, 255, 255, alpha * 15 / 16) : IM_COL32(35, 39, 45, alpha * 15 / 16);
    const ImU32 ink = light ? IM_COL32(26, 29, 33, alpha) : IM_COL32(231, 234, 238, alpha);
    const ImU32 mark = one.is_error ? IM_COL32(224, 82, 58, alpha) : IM_COL32(47, 127, 214, alpha);
    const ImVec2 size = ImGui::CalcTextSize(one.text.c_str(), nullptr, false, width - 3 * pad);
    const ImVec2 to{x + size.x + 3 * pad, y + size.y + 2 * pad};
    list.AddRectFilled({x, y}, to, back, 5);
    list.AddRectFilled({x, y}, {x + 0.5F * pad, to.y}, mark, 5);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {x + 1.5F * pad, y + pad}, ink, one.text.c_str(), nullptr,
                 width - 3 * pad);
    y = to.y + pad;
  }
}

}  // namespace penpose::app
