#include <algorithm>
#include <string>
#include <vector>

#include "ui/app/canvas/canvas.h"
#include "ui/app/face/feature_words.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"

// What each line of the face was taken for, beside it; a touch opens the menu that changes it.

namespace penpose::app {
namespace {

struct FaceLabel {
  document::CurveId id;
  std::string text;
  bool known = true;
  Area area{};
};

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

}  // namespace

void show_face_labels(PanelContext& context, const Area& free, EditingSession& editing, Canvas& canvas,
                      PanelState& panels) {
  const drawing::ToolKind tool = editing.editor().tool().kind;
  const auto& face = editing.document().face;
  panels.face_labels.clear();
  if (!face || !panels.shown || !editing.moments().shows(face->time_s) || editing.pen_is_drawing()) return;
  if (tool != drawing::ToolKind::draw && tool != drawing::ToolKind::none) return;
  const auto high = 0.7 * static_cast<double>(context.unit), gap = static_cast<double>(context.gap);
  std::vector<std::vector<PxPoint>> lines;
  std::vector<FaceLabel> labels;
  double sum = 0, count = 0;
  for (const document::FaceLine& line : face->lines) {
    auto seen = document::line_in(canvas.view(), *face, line);
    if (!seen) return;
    for (const PxPoint& p : *seen) {
      sum += p.x;
      count += 1;
    }
    const std::string words = line.feature.empty() ? "?" : feature_words(line.feature);
    labels.push_back({line.id, words, !line.feature.empty(), {}});
    lines.push_back(std::move(*seen));
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double wide = static_cast<double>(ImGui::CalcTextSize(labels[i].text.c_str()).x) + 2 * gap;
    Area area = beside(lines[i], sum / count, wide, high, gap);
    area.left = std::clamp(area.left, free.left, std::max(free.left, free.right - wide));
    area.right = area.left + wide;
    // Below those that are there already.
    for (bool again = true; again;) {
      again = false;
      for (std::size_t k = 0; k < i; ++k) {
        if (!overlap(area, labels[k].area)) continue;
        area.top = labels[k].area.bottom + 1;
        area.bottom = area.top + high;
        again = true;
      }
    }
    labels[i].area = area;
  }
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Area& area = labels[i].area;
    if (area.bottom > free.bottom || area.top < free.top) continue;
    panels.face_labels.emplace_back(labels[i].id, area);
    context.targets["line " + std::to_string(i + 1)] = area;
    const bool hovered = area.holds({static_cast<double>(mouse.x), static_cast<double>(mouse.y)}) &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow) && !context.menu_open &&
                         !context.dialog_area && !ImGui::IsAnyItemActive() && !panels.curve_menu;
    const ImVec2 from{static_cast<float>(area.left), static_cast<float>(area.top)};
    const ImVec2 to{static_cast<float>(area.right), static_cast<float>(area.bottom)};
    const ImU32 back = labels[i].known ? IM_COL32(28, 62, 110, 215) : IM_COL32(120, 74, 10, 225);
    list.AddRectFilled(from, to, back, 0.35F * (to.y - from.y));
    if (hovered) list.AddRect(from, to, IM_COL32(255, 255, 255, 230), 0.35F * (to.y - from.y), 0, 2);
    const ImVec2 size = ImGui::CalcTextSize(labels[i].text.c_str());
    list.AddText({0.5F * (from.x + to.x - size.x), 0.5F * (from.y + to.y - size.y)}, IM_COL32(255, 255, 255, 255),
                 labels[i].text.c_str());
    if (hovered) context.tip_waits = true;
    if (hovered && context.tip_due) ImGui::SetTooltip("What this line was taken for: press to say what it is");
  }
}

}  // namespace penpose::app
