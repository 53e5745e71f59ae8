#include "ui/app/panels/face/line_names.h"

#include <algorithm>

#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// Share of its height that a name keeps free above and below.
constexpr double k_name_inset = 0.15;

using document::PxPoint;

/// Beside the end of a line that lies farther from the middle of the face.
Area beside(const std::vector<PxPoint>& line, double middle_x, double wide, double high, double gap) {
  PxPoint left = line.front(), right = line.front();
  for (const PxPoint& p : line) {
    if (p.x < left.x) left = p;
    if (p.x > right.x) right = p;
  }
  const bool on_left = 0.5 * (left.x + right.x) < middle_x;
  const PxPoint end = on_left ? left : right;
  const double x = on_left ? end.x - gap - wide : end.x + gap;
  return {x, end.y - 0.5 * high, x + wide, end.y + 0.5 * high};
}

bool overlap(const Area& a, const Area& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

double middle_x(const std::vector<LineName>& names) {
  double sum = 0, count = 0;
  for (const LineName& one : names) {
    for (const PxPoint& p : one.line) {
      sum += p.x;
      count += 1;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

/// Where each name is, below those that are there already.
std::vector<Area> places_of(const PanelContext& context, const Area& free, const std::vector<LineName>& names) {
  const auto high = static_cast<double>(context.unit), gap = static_cast<double>(context.gap);
  const double middle = middle_x(names);
  std::vector<Area> out;
  for (const LineName& one : names) {
    const double wide = static_cast<double>(ImGui::CalcTextSize(one.text.c_str()).x) + 2 * gap;
    Area area = beside(one.line, middle, wide, high, gap);
    area.left = std::clamp(area.left, free.left, std::max(free.left, free.right - wide));
    area.right = area.left + wide;
    for (bool again = true; again;) {
      again = false;
      for (const Area& other : out) {
        if (!overlap(area, other)) continue;
        area.top = other.bottom + 1;
        area.bottom = area.top + high;
        again = true;
      }
    }
    out.push_back(area);
  }
  return out;
}

}  // namespace

std::vector<std::optional<Area>> show_line_names(PanelContext& context, const Area& free,
                                                 const std::vector<LineName>& names, bool touchable, const char* tip) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  std::vector<std::optional<Area>> out;
  const std::vector<Area> places = places_of(context, free, names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Area& area = places[i];
    out.emplace_back();
    if (area.bottom > free.bottom || area.top < free.top) continue;
    out.back() = area;
    const bool hovered = touchable && area.holds({static_cast<double>(mouse.x), static_cast<double>(mouse.y)}) &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow) && !context.menu_open &&
                         !context.dialog_area && !ImGui::IsAnyItemActive();
    // What is touched is higher than what is seen, which is to hide little.
    const double inset = k_name_inset * area.height();
    const ImVec2 from{static_cast<float>(area.left), static_cast<float>(area.top + inset)};
    const ImVec2 to{static_cast<float>(area.right), static_cast<float>(area.bottom - inset)};
    const ImU32 back = color_of(names[i].known ? k_canvas_colors.name_known : k_canvas_colors.name_guess, 0.87F);
    list.AddRectFilled(from, to, back, 0.35F * (to.y - from.y));
    if (hovered) list.AddRect(from, to, color_of(k_canvas_colors.ink), 0.35F * (to.y - from.y), 0, scaled(2));
    const ImVec2 size = ImGui::CalcTextSize(names[i].text.c_str());
    list.AddText({0.5F * (from.x + to.x - size.x), 0.5F * (from.y + to.y - size.y)}, color_of(k_canvas_colors.ink),
                 names[i].text.c_str());
    if (hovered) context.tip_waits = true;
    if (hovered && context.tip_due) ImGui::SetTooltip("%s", tip);
  }
  return out;
}

}  // namespace penpose::app
