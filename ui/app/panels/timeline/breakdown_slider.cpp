#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

constexpr double k_overshoots = 0.3;  ///< beyond both keys
constexpr float k_snap_px = 4;

/// The slider as it lies on the panel.
struct Between {
  ImVec2 from, to;
  float inset = 0;
  [[nodiscard]] float x_of(double share) const {
    const auto along = static_cast<float>((share + k_overshoots) / (1 + 2 * k_overshoots));
    return from.x + inset + along * (to.x - from.x - 2 * inset);
  }
  /// The share at a place, which sticks to the marks.
  [[nodiscard]] double share_of(float x) const {
    for (const double mark : {0.0, 0.5, 1.0}) {
      if (std::abs(x_of(mark) - x) <= scaled(k_snap_px)) return mark;
    }
    const double along = static_cast<double>((x - from.x - inset) / (to.x - from.x - 2 * inset));
    const double share = std::clamp(along, 0.0, 1.0) * (1 + 2 * k_overshoots) - k_overshoots;
    return std::round(100 * share) / 100;
  }
};

std::string percent(double share) { return std::to_string(static_cast<int>(std::lround(100 * share))) + " %"; }

void draw_marks(const Between& slider) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 faint = ImGui::GetColorU32(ImGuiCol_Text, 0.6F);
  // Between both keys it is one ground, beyond them another.
  list.AddRectFilled({slider.x_of(0), slider.from.y}, {slider.x_of(1), slider.to.y},
                     ImGui::GetColorU32(ImGuiCol_Text, 0.07F));
  const float high = slider.to.y - slider.from.y;
  for (const double tick : {-0.25, 0.25, 0.75, 1.25}) {
    const float x = slider.x_of(tick);
    list.AddLine({x, slider.to.y - 0.18F * high}, {x, slider.to.y - scaled(2)},
                 ImGui::GetColorU32(ImGuiCol_Text, 0.4F));
  }
  ImGui::PushFont(small_font());
  for (const auto& [mark, text] : {std::pair{0.0, "0"}, std::pair{0.5, "50"}, std::pair{1.0, "100"}}) {
    const float x = slider.x_of(mark);
    const float top = mark == 0.5 ? slider.to.y - 0.45F * high : slider.from.y + 2;
    list.AddLine({x, top}, {x, slider.to.y - scaled(2)}, ImGui::GetColorU32(ImGuiCol_Text, 0.4F));
    list.AddText({x + scaled(3), slider.to.y - ImGui::GetFontSize() - 1}, faint, text);
  }
  ImGui::PopFont();
}

/// What the pen holds, with its number above, where the hand does not cover it.
void draw_knob(PanelContext& context, const Between& slider, double share) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = slider.x_of(share);
  const float middle = 0.5F * (slider.from.y + slider.to.y);
  const float rest = slider.x_of(std::clamp(share, 0.0, 1.0) < 0.5 ? 0 : 1);
  if (share < 0 || share > 1)
    list.AddRectFilled({std::min(rest, x), slider.from.y + scaled(3)}, {std::max(rest, x), slider.to.y - scaled(3)},
                       color_of(palette().record, 0.35F));
  draw_key({x, middle}, 0.26F * context.unit, color_of(palette().key_here), true);
  const std::string said = share < 0 || share > 1 ? percent(share) + ", overshoots" : percent(share);
  const ImVec2 size = ImGui::CalcTextSize(said.c_str());
  ImDrawList& above = *ImGui::GetForegroundDrawList();
  const ImVec2 at{x - 0.5F * size.x, slider.from.y - size.y - scaled(12)};
  above.AddRectFilled({at.x - scaled(6), at.y - scaled(4)}, {at.x + size.x + scaled(6), at.y + size.y + scaled(4)},
                      ImGui::GetColorU32(ImGuiCol_PopupBg), ImGui::GetStyle().FrameRounding);
  above.AddText(at, ImGui::GetColorU32(ImGuiCol_Text), said.c_str());
}

}  // namespace

void show_breakdown(PanelContext& context, const TimelineOwners& with, float width) {
  Between slider;
  slider.from = ImGui::GetCursorScreenPos();
  slider.inset = 0.2F * context.unit;
  ImGui::InvisibleButton("##breakdown", {width, context.unit});
  slider.to = ImGui::GetItemRectMax();
  note(context, "slider Between");
  tooltip(context,
          "A pose between the key before (0) and the key after (100), keyed at the playhead when let go; beyond them "
          "it overshoots");
  const bool pressed = ImGui::IsItemActivated();
  const bool active = ImGui::IsItemActive();
  const bool released = ImGui::IsItemDeactivated();
  const bool hovered = ImGui::IsItemHovered();
  auto& held = with.shown().breakdown;
  if (pressed) {
    const std::string lacks = with.keys.tween_lacks();
    if (!lacks.empty()) with.notices.tell(lacks);
    held.reset();
    if (lacks.empty()) held = slider.share_of(ImGui::GetIO().MousePos.x);
  }
  if (active && held) {
    held = slider.share_of(ImGui::GetIO().MousePos.x);
    with.keys.preview_tween(*held);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(slider.from, slider.to, ImGui::GetColorU32(hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                     ImGui::GetStyle().FrameRounding);
  draw_marks(slider);
  if (held) {
    draw_knob(context, slider, *held);
  } else {
    const char* name = "Between";
    const float wide = ImGui::CalcTextSize(name).x;
    list.AddText({0.5F * (slider.from.x + slider.to.x - wide), slider.from.y + scaled(2)},
                 ImGui::GetColorU32(ImGuiCol_Text, 0.8F), name);
  }
  if (released && held) {
    const double share = *held;
    held.reset();
    with.keys.tween(share);
  }
}

}  // namespace penpose::app
