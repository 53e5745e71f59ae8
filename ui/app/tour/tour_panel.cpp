#include "ui/app/tour/tour_panel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/files/files.h"
#include "ui/app/tour/tour_guide.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// A card so wide has its buttons beside its text.
constexpr double k_beside_units = 13;
constexpr float k_buttons_units = 6.4F;

struct CardText {
  std::string counted;
  std::string says;
  std::string again;
};

CardText text_of(const TourGuide& guide) {
  const std::size_t all = guide.tour().steps.size();
  const std::string where = guide.done() ? "done" : std::to_string(guide.step() + 1) + " of " + std::to_string(all);
  return {"Tour: " + guide.tour().title + ", " + where, guide.says(), guide.again()};
}

bool buttons_beside(const PanelContext& context, double width) {
  return width >= k_beside_units * static_cast<double>(context.unit);
}

float text_width(const PanelContext& context, double width) {
  const float room = static_cast<float>(width) - 3 * context.gap;
  return buttons_beside(context, width) ? room - k_buttons_units * context.unit : room;
}

float height_of(const std::string& text, float width) {
  return text.empty() ? 0 : ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y;
}

void add_dashed(ImDrawList& list, const std::vector<ImVec2>& line, float scale) {
  const float dash = 9 * scale;
  const float gap = 6 * scale;
  const auto draw = [&](float width, ImU32 color) {
    float left = dash;
    bool on = true;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      ImVec2 from = line[i];
      const ImVec2 to = line[i + 1];
      float length = std::hypot(to.x - from.x, to.y - from.y);
      while (length > 0) {
        const float part = std::min(left, length);
        const ImVec2 next{from.x + (to.x - from.x) * part / length, from.y + (to.y - from.y) * part / length};
        if (on) list.AddLine(from, next, color, width);
        length -= part;
        left -= part;
        from = next;
        if (left > 1e-3F) continue;
        on = !on;
        left = on ? dash : gap;
      }
    }
  };
  draw(6 * scale, color_of(k_canvas_colors.shade, 0.6F));
  draw(3.4F * scale, color_of(k_canvas_colors.tour));
}

/// A disc where it begins, an arrow where it ends.
void add_ends(ImDrawList& list, const std::vector<ImVec2>& line, float scale, bool closed) {
  list.AddCircleFilled(line.front(), 7 * scale, color_of(k_canvas_colors.shade, 0.6F));
  list.AddCircleFilled(line.front(), 5.5F * scale, color_of(k_canvas_colors.tour));
  // Of a line that comes back the arrow says which way round.
  const std::size_t tip = closed ? std::min<std::size_t>(3, line.size() - 1) : line.size() - 1;
  std::size_t tail = tip;
  float length = 0;
  while (tail > 0 && length < 8 * scale) {
    --tail;
    length = std::hypot(line[tip].x - line[tail].x, line[tip].y - line[tail].y);
  }
  if (length <= 0) return;
  const ImVec2 way{(line[tip].x - line[tail].x) / length, (line[tip].y - line[tail].y) / length};
  const ImVec2 end{line[tip].x + 5 * scale * way.x, line[tip].y + 5 * scale * way.y};
  const float size = 11 * scale;
  const ImVec2 a{end.x - size * (way.x + 0.6F * way.y), end.y - size * (way.y - 0.6F * way.x)};
  const ImVec2 b{end.x - size * (way.x - 0.6F * way.y), end.y - size * (way.y + 0.6F * way.x)};
  list.AddTriangleFilled(end, a, b, color_of(k_canvas_colors.tour));
  list.AddTriangle(end, a, b, color_of(k_canvas_colors.shade, 0.6F), 1.2F * scale);
}

}  // namespace

double tour_height(const PanelContext& context, double width, const TourGuide& guide) {
  if (!guide.active()) return 0;
  const CardText text = text_of(guide);
  const float wide = text_width(context, width);
  // As high for every step, so that the face stays where it is.
  float says = height_of(guide.tour().ends, wide);
  for (const TourStep& step : guide.tour().steps) says = std::max(says, height_of(step.says, wide));
  const float words = height_of(text.counted, wide) + std::max(says, height_of(text.says, wide)) +
                      std::max(ImGui::GetTextLineHeight(), height_of(text.again, wide)) + 1.5F * context.gap;
  const float high = buttons_beside(context, width) ? std::max(words, context.unit) : words + context.unit;
  return static_cast<double>(high + 3 * context.gap);
}

void show_tour(PanelContext& context, const Area& area, TourGuide& guide, Files& files) {
  if (!guide.active()) return;
  const CardText text = text_of(guide);
  const bool beside = buttons_beside(context, area.width());
  const float wide = text_width(context, area.width());
  enum class Pressed : std::uint8_t { none, skip, leave, next } pressed = Pressed::none;
  const auto found = std::find(k_tours.begin(), k_tours.end(), guide.tour().name);
  const auto next = found == k_tours.end() ? found : found + 1;
  if (begin_panel(context, "tour", area)) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto left = static_cast<float>(area.left);
    const auto top = static_cast<float>(area.top);
    list.AddRectFilled({left, top}, {left + context.gap, static_cast<float>(area.bottom)}, color_of(palette().lit));
    float y = top + context.gap;
    const float x = left + 2 * context.gap;
    const auto say = [&](const std::string& words, ImU32 color) {
      if (words.empty()) return;
      list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {x, y}, color, words.c_str(), nullptr, wide);
      y += height_of(words, wide) + 0.5F * context.gap;
    };
    say(text.counted, ImGui::GetColorU32(ImGuiCol_TextDisabled));
    say(text.says, ImGui::GetColorU32(ImGuiCol_Text));
    say(text.again, color_of(palette().asks));
    const float width = 0.5F * ((beside ? k_buttons_units * context.unit : wide) - 2 * context.gap);
    const float button_y = beside ? static_cast<float>(area.middle().y) - 0.5F * context.unit
                                  : static_cast<float>(area.bottom) - context.unit - context.gap;
    ImGui::SetCursorScreenPos({beside ? static_cast<float>(area.right) - k_buttons_units * context.unit : x, button_y});
    if (!guide.done()) {
      bool held = false;
      if (wide_button(context, "Skip##tour", width, false, "Do this step for me")) pressed = Pressed::skip;
      held = ImGui::IsItemActive();
      ImGui::SameLine();
      if (wide_button(context, "Leave##tour", width, false, "Leave the tour and keep the drawing"))
        pressed = Pressed::leave;
      held = held || ImGui::IsItemActive();
      const ImVec2 from = ImGui::GetIO().MouseClickedPos[0];
      const bool here = area.holds({static_cast<double>(from.x), static_cast<double>(from.y)});
      if (!held && here && ImGui::IsMouseDragging(0, context.unit)) guide.drag_beside();
    } else {
      if (next != k_tours.end()) {
        if (primary_button(context, "Next tour##tour", width)) pressed = Pressed::next;
        ImGui::SameLine();
      }
      if (wide_button(context, "Close##tour", width)) pressed = Pressed::leave;
    }
  }
  end_panel();
  if (pressed == Pressed::skip) guide.skip();
  if (pressed == Pressed::leave) guide.leave();
  // What was drawn on a tour is kept with its session; nobody is asked about it.
  if (pressed == Pressed::next) files.try_open("tour:" + std::string(*next));
}

void show_tour_ghost(PanelContext& context, const Area& /*area*/, Canvas& canvas, TourGuide& guide, Dialogs& dialogs) {
  if (!guide.active() || dialogs.open() != Dialog::none || context.menu_open) return;
  const auto scale = static_cast<float>(canvas.scale());
  if (const std::string label = guide.pointed(); !label.empty()) {
    const auto found = context.targets.find(label);
    if (found == context.targets.end()) return;
    const Area& at = found->second;
    const auto out = static_cast<double>(1.5F * scale);
    ImGui::GetForegroundDrawList()->AddRect({static_cast<float>(at.left - out), static_cast<float>(at.top - out)},
                                            {static_cast<float>(at.right + out), static_cast<float>(at.bottom + out)},
                                            color_of(palette().lit), 6 * scale, 0, 3 * scale);
    return;
  }
  const auto camera = geometry::Camera::make(canvas.view().camera, canvas.view().viewport);
  std::vector<ImVec2> line;
  for (const auto& point : guide.ghost()) {
    const auto px = camera ? camera->project(point) : std::nullopt;
    if (px) line.emplace_back(static_cast<float>(px->x), static_cast<float>(px->y));
  }
  if (line.size() < 2) return;
  if (guide.ghost_closed()) line.push_back(line.front());
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  add_dashed(list, line, scale);
  add_ends(list, line, scale, guide.ghost_closed());
}

void show_tour_buttons(PanelContext& context) {
  for (const Action action : {Action::tour_pose, Action::tour_rig, Action::tour_animate}) {
    const ActionInfo& one = info(action);
    ButtonLook look{-1, false, nullptr, "M7 4L20 12L7 20F"};
    look.left_aligned = true;
    if (!icon_button(context, std::string(one.label).c_str(), look)) continue;
    context.actions.run(Action::cancel);
    context.actions.run(action);
  }
}

}  // namespace penpose::app
