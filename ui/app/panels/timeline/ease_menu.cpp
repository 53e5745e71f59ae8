#include <algorithm>
#include <string>
#include <vector>

#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/time_actions.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// How the face goes to the next key, as small pictures of the curves.

namespace penpose::app {
namespace {

constexpr int k_ease_points = 24;

/// The picture of a kind: how far the way is done at a share of the time.
double way_done(document::KeyKind kind, double t) {
  switch (kind) {
    case document::KeyKind::linear:
      return t;
    case document::KeyKind::stepped:
      return t < 1 ? 0 : 1;
    case document::KeyKind::ease_in:
      return t * t;
    case document::KeyKind::ease_out:
      return 1 - (1 - t) * (1 - t);
    case document::KeyKind::ease:
      return t * t * t * (10 - t * (15 - 6 * t));
    case document::KeyKind::overshoot:
      // A cubic that leaves fast and comes back to its end.
      return t * (6 - t * (9 - t * 4));
    case document::KeyKind::free:
      return t * (0.2 + t * (2.6 - t * 1.8));
    case document::KeyKind::smooth:
    case document::KeyKind::none:
      break;
  }
  return t * (0.5 + t * (1.5 - t));
}

void draw_ease(ImDrawList& list, document::KeyKind kind, ImVec2 from, ImVec2 to, float alpha, float line) {
  const ImU32 ink = color_of(palette().ink, alpha);
  const bool beyond = kind == document::KeyKind::overshoot;
  const float top = beyond ? from.y + 0.22F * (to.y - from.y) : from.y;
  const auto at = [&](double t, double done) {
    return ImVec2{from.x + static_cast<float>(t) * (to.x - from.x), to.y - static_cast<float>(done) * (to.y - top)};
  };
  const ImU32 faint = color_of(palette().faint, 0.5F * alpha);
  if (beyond) list.AddLine({from.x, top}, {to.x, top}, faint);
  if (kind == document::KeyKind::free || beyond) {
    // Its handles.
    const ImVec2 first = at(0.32, kind == document::KeyKind::free ? 0.06 : 0.95);
    const ImVec2 last = at(0.68, kind == document::KeyKind::free ? 0.98 : 1.2);
    list.AddLine(at(0, 0), first, faint, 1);
    list.AddLine(at(1, 1), last, faint, 1);
    list.AddCircleFilled(first, 1.6F * line, faint, 8);
    list.AddCircleFilled(last, 1.6F * line, faint, 8);
  }
  for (int i = 0; i <= k_ease_points; ++i) {
    const double t = static_cast<double>(i) / k_ease_points;
    if (kind == document::KeyKind::stepped && i == k_ease_points) list.PathLineTo(at(1, 0));
    list.PathLineTo(at(t, way_done(kind, t)));
  }
  list.PathStroke(ink, 0, line);
  list.AddCircleFilled(at(0, 0), 1.2F * line, ink, 10);
  list.AddCircleFilled(at(1, 1), 1.2F * line, ink, 10);
  // It goes on through its keys.
  if (kind == document::KeyKind::smooth) list.AddCircleFilled(at(0.5, 0.5), 1.2F * line, ink, 10);
}

const KeyKindInfo& info_of(document::KeyKind kind) {
  const auto all = key_kinds();
  const auto found = std::find_if(all.begin(), all.end(), [&](const KeyKindInfo& one) { return one.kind == kind; });
  return found == all.end() ? all.front() : *found;
}

/// One of all, as a picture with its name below.
bool show_kind(PanelContext& context, const KeyKindInfo& one, bool on, bool among) {
  const ImVec2 size{2.7F * context.unit, 2 * context.unit};
  const std::string label = std::string(one.name) + "##choose kind";
  ImGui::PushID(label.c_str());
  const bool pressed = ImGui::InvisibleButton("##kind", size);
  ImGui::PopID();
  note(context, label.c_str());
  tooltip(context, one.tip);
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool lit = ImGui::IsItemHovered();
  const Palette& colors = palette();
  list.AddRectFilled(from, to,
                     color_of(on    ? colors.chosen
                              : lit ? colors.hovered
                                    : colors.button),
                     ImGui::GetStyle().FrameRounding);
  if (on || among) list.AddRect(from, to, color_of(colors.accent), ImGui::GetStyle().FrameRounding, 0, scaled(2));
  const ImU32 ink = color_of(colors.ink);
  const float side = 0.35F * context.unit;
  const float text_y = to.y - ImGui::GetFontSize() - scaled(3);
  draw_ease(list, one.kind, {from.x + side, from.y + 0.25F * context.unit}, {to.x - side, text_y - 0.2F * context.unit},
            1, scaled(2));
  const float wide = ImGui::CalcTextSize(one.name).x;
  list.AddText({0.5F * (from.x + to.x - wide), text_y}, ink, one.name);
  return pressed;
}

void show_kinds_menu(PanelContext& context, const TimelineOwners& with, const std::vector<document::KeyKind>& now) {
  if (!begin_menu(context, "kinds")) return;
  const std::string said = with.keys.said();
  const std::string from =
      said.empty() ? "There is no key here or before: key a pose first" : "From " + said + " to the next";
  ImGui::TextUnformatted(from.c_str());
  if (now.size() > 1) {
    std::string mixed = "Mixed: ";
    for (const document::KeyKind kind : now)
      mixed += (kind == now.front() ? "" : ", ") + std::string(info_of(kind).name);
    ImGui::TextUnformatted(mixed.c_str());
  }
  int column = 0;
  constexpr int k_across = 4;
  for (const KeyKindInfo& one : key_kinds()) {
    if (column++ % k_across != 0) ImGui::SameLine();
    const bool has = std::find(now.begin(), now.end(), one.kind) != now.end();
    if (!show_kind(context, one, has && now.size() == 1, has && now.size() > 1)) continue;
    with.keys.set_kind(one.kind);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace

void show_ease(PanelContext& context, const TimelineOwners& with, float width) {
  const auto now = with.keys.kinds();
  const document::KeyKind shown = now.empty() ? document::KeyKind::smooth : now.front();
  const std::string name = now.size() > 1 ? "Mixed" : info_of(shown).name;
  const std::string label = name + "##kind";
  ImGui::PushID("ease");
  if (ImGui::Button("##button", {width, context.unit})) ImGui::OpenPopup("kinds");
  note(context, label.c_str());
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  tooltip(context, "How the face goes to the next key: from the selected keys, else from the key here or before");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  const float pad = 0.22F * context.unit;
  // The picture alone, where there is room for no more.
  const bool worded = width >= 0.75F * context.unit + 3 * pad + ImGui::CalcTextSize(name.c_str()).x;
  const float left = worded ? from.x + pad : 0.5F * (from.x + to.x - 0.75F * context.unit);
  const ImVec2 picture{left, from.y + 0.28F * context.unit};
  const ImVec2 end{picture.x + 0.75F * context.unit, to.y - 0.28F * context.unit};
  // Of several kinds each is drawn faintly over the others.
  if (now.size() > 1) {
    for (const document::KeyKind kind : now) draw_ease(list, kind, picture, end, 0.55F, scaled(1.5F));
  } else {
    draw_ease(list, shown, picture, end, 1, scaled(2));
  }
  if (worded) {
    list.AddText({end.x + pad, from.y + 0.5F * (to.y - from.y - ImGui::GetFontSize())}, ink, name.c_str());
  }
  show_kinds_menu(context, with, now);
  ImGui::PopID();
}

}  // namespace penpose::app
