#include "ui/app/widgets/internal/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/app/view/toast_place.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"

namespace penpose::app {
namespace {

constexpr float k_pi = 3.14159265F;

/// Part of a target's height that an icon takes.
constexpr float k_icon = 0.56F;
/// How dark the shade is behind a dialog.
constexpr float k_shade = 0.45F;

/// A padlock on a target, its bow turned aside where it is open.
void draw_padlock(ImDrawList& list, const ImVec2& middle, float unit, bool closed, ImU32 ink) {
  const float half = 0.17F * unit;
  const float top = middle.y - 0.02F * unit;
  list.AddRectFilled({middle.x - half, top}, {middle.x + half, top + 0.27F * unit}, ink, 0.04F * unit);
  const float bow = 0.11F * unit;
  const float x = closed ? middle.x : middle.x + 2 * bow;
  const float foot = top - 0.06F * unit;
  list.PathLineTo({x - bow, top});
  list.PathArcTo({x, foot}, bow, k_pi, 2 * k_pi, 12);
  if (closed) list.PathLineTo({x + bow, top});
  list.PathStroke(ink, 0, 0.06F * unit);
}

bool overlap(const Area& area, ImVec2 corner, ImVec2 size) {
  return area.left < static_cast<double>(corner.x + size.x) && static_cast<double>(corner.x) < area.right &&
         area.top < static_cast<double>(corner.y + size.y) && static_cast<double>(corner.y) < area.bottom;
}

}  // namespace

void note(PanelContext& context, const char* label) {
  if (!ImGui::IsItemVisible()) return;
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 most = ImGui::GetItemRectMax();
  context.targets[label] = {least.x, least.y, most.x, most.y};
}

void tooltip(PanelContext& context, const char* text) {
  if (text == nullptr || *text == 0 || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  context.tip_waits = true;
  if (!context.tip_due) return;
  context.tip = text;
  // Over the canvas beside the panel that the item is on, else below it.
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 most = ImGui::GetItemRectMax();
  const Area free = context.free;
  const auto left = static_cast<float>(free.left);
  const auto right = static_cast<float>(free.right);
  const auto top = static_cast<float>(free.top);
  const auto bottom = static_cast<float>(free.bottom);
  ImVec2 at{least.x, most.y + context.gap};
  ImVec2 pivot{0, 0};
  const bool panels = context.panels_shown && !context.menu_open && !context.dialog_area;
  if (panels && most.x <= left) at = {left + context.gap, least.y};
  if (panels && least.x >= right) {
    at = {right - context.gap, least.y};
    pivot.x = 1;
  }
  if (panels && most.y <= top) at = {least.x, top + context.gap};
  if (panels && least.y >= bottom) {
    at = {least.x, bottom - context.gap};
    pivot.y = 1;
  }
  const float most_wide = ImGui::GetFontSize() * 20;
  if (pivot.x == 0) {
    const float wide = ImGui::CalcTextSize(text, nullptr, false, most_wide).x + 2 * ImGui::GetStyle().WindowPadding.x;
    at.x = std::max(0.0F, std::min(at.x, static_cast<float>(context.window.width) - wide - context.gap));
  }
  // A tip does not cover notices: it moves below them, or above them if there is no room.
  const ImVec2 inner = ImGui::CalcTextSize(text, nullptr, false, most_wide);
  const ImVec2 size{inner.x + 2 * ImGui::GetStyle().WindowPadding.x, inner.y + 2 * ImGui::GetStyle().WindowPadding.y};
  const ImVec2 corner{at.x - pivot.x * size.x, at.y - pivot.y * size.y};
  if (const auto& said = context.own.of<ToastPlace>().area; said && overlap(*said, corner, size)) {
    const bool room = said->bottom + static_cast<double>(size.y + context.gap) < context.window.height;
    pivot.y = room ? 0 : 1;
    at.y = room ? static_cast<float>(said->bottom) + context.gap : static_cast<float>(said->top) - context.gap;
  }
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(most_wide);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

float button_width(const PanelContext& context, const char* label, std::string_view icon, bool text) {
  const float wide = text ? ImGui::CalcTextSize(label, nullptr, true).x : 0;
  const float drawn = icon.empty() ? 0 : k_icon * context.unit + (text ? context.gap : 0);
  return std::max(context.unit, wide + drawn + 0.6F * context.unit);
}

namespace {

/// The colours of a button, as ImGui and what is drawn on it take them.
struct ButtonColors {
  ImVec4 ground;
  ImVec4 hovered;
  Rgb ink;
};

ButtonColors colors_of(const ButtonLook& look) {
  const Palette& p = palette();
  if (look.lit) return {vec_of(p.lit), vec_of(p.lit), p.on_lit};
  if (look.weight == ButtonWeight::primary) return {vec_of(p.accent), vec_of(p.accent_hovered), p.on_accent};
  // What is on is seen to be on under the pen, too.
  if (look.chosen) return {vec_of(p.chosen), vec_of(p.chosen), p.ink};
  return {vec_of(p.button, look.weight == ButtonWeight::quiet ? 0 : 1), vec_of(p.hovered), p.ink};
}

/// What stands on the button that was just made: an icon, its word as far as it fits, its key.
void draw_on_button(const PanelContext& context, std::string_view label, const ButtonLook& look, Rgb color) {
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 most = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(least, most, true);
  const ImU32 ink = color_of(ImGui::IsItemActive() ? palette().on_accent : color);
  const std::string_view said = look.text ? label.substr(0, label.find("##")) : std::string_view();
  float icon_px = look.icon.empty() ? 0 : k_icon * context.unit;
  float between = icon_px > 0 && !said.empty() ? context.gap : 0;
  const float key_px = look.key.empty() ? 0 : ImGui::CalcTextSize(look.key.data(), look.key.data() + look.key.size()).x;
  const float pad = 0.22F * context.unit;
  // A word that is whole says more than a part of it beside a picture.
  const float word_px = ImGui::CalcTextSize(said.data(), said.data() + said.size()).x;
  if (word_px > most.x - least.x - icon_px - between - 2 * pad - key_px + 1) icon_px = between = 0;
  const std::string text = fitted_text(said, most.x - least.x - icon_px - between - 2 * pad - key_px + 1);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  float x = look.left_aligned ? least.x + pad : 0.5F * (least.x + most.x - icon_px - between - size.x);
  const float middle = 0.5F * (least.y + most.y);
  if (icon_px > 0) draw_icon(list, look.icon, {x + 0.5F * icon_px, middle}, icon_px, ink);
  x += icon_px + between;
  list.AddText({x, middle - 0.5F * size.y}, ink, text.c_str());
  if (key_px > 0) {
    list.AddText({most.x - pad - key_px, middle - 0.5F * size.y},
                 look.chosen ? ink : ImGui::GetColorU32(ImGuiCol_TextDisabled), look.key.data(),
                 look.key.data() + look.key.size());
  }
  list.PopClipRect();
}

}  // namespace

bool icon_button(PanelContext& context, const char* label, const ButtonLook& look) {
  const float width = look.width != 0 ? look.width : button_width(context, label, look.icon, look.text);
  const ButtonColors colors = colors_of(look);
  ImGui::PushStyleColor(ImGuiCol_Button, colors.ground);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colors.hovered);
  ImGui::PushID(label);
  const bool pressed = ImGui::Button("##button", {width, context.unit});
  ImGui::PopID();
  ImGui::PopStyleColor(2);
  note(context, label);
  draw_on_button(context, label, look, colors.ink);
  tooltip(context, look.tip);
  return pressed;
}

bool primary_button(PanelContext& context, const char* label, float width, const char* tip) {
  ButtonLook look{width, false, tip};
  look.weight = ButtonWeight::primary;
  return icon_button(context, label, look);
}

bool quiet_icon(PanelContext& context, const char* label, std::string_view icon, const char* tip, bool chosen) {
  ButtonLook look{context.unit, chosen, tip, icon, false};
  look.weight = ButtonWeight::quiet;
  return icon_button(context, label, look);
}

bool wide_button(PanelContext& context, const char* label, float width, bool chosen, const char* tip) {
  return icon_button(context, label, {width, chosen, tip});
}

float menu_column(const PanelContext& context) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float beside = 2 * context.gap + 2 * style.WindowPadding.x + style.ItemSpacing.x + style.ScrollbarSize;
  return std::min(9 * context.unit, 0.5F * (static_cast<float>(context.window.width) - beside));
}

bool menu_entry(PanelContext& context, const char* label, std::string_view icon, std::string_view key,
                const char* tip) {
  const float width = menu_column(context);
  const float wide =
      button_width(context, label, icon, true) + ImGui::CalcTextSize(key.data(), key.data() + key.size()).x;
  if (wide > width) key = {};
  return icon_button(context, label, {width, false, tip, icon, true, true, key, ButtonWeight::quiet});
}

bool lock_button(PanelContext& context, const char* label, bool locked, const char* tip) {
  const bool pressed = quiet_icon(context, label, {}, tip, locked);
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 most = ImGui::GetItemRectMax();
  const ImU32 ink = ImGui::GetColorU32(locked ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  draw_padlock(*ImGui::GetWindowDrawList(), {0.5F * (least.x + most.x), 0.5F * (least.y + most.y)}, context.unit,
               locked, ink);
  return pressed;
}

bool action_button(PanelContext& context, Action action, float width, bool chosen, const char* label,
                   ButtonWeight weight) {
  const std::string own(info(action).label);
  const std::string tip = context.actions.keys().tooltip_of(action);
  const std::string_view icon = label == nullptr ? icon_of(action) : std::string_view();
  ButtonLook look{width, chosen, tip.c_str(), icon};
  look.left_aligned = width == -1 && !icon.empty();
  look.weight = weight;
  if (!icon_button(context, label != nullptr ? label : own.c_str(), look)) return false;
  context.actions.run(action);
  return true;
}

bool tool_button(PanelContext& context, Action action, float width, bool words, bool chosen, ButtonWeight weight,
                 const char* label) {
  const std::string own(info(action).label);
  const std::string tip = context.actions.keys().tooltip_of(action);
  ButtonLook look{width, chosen, tip.c_str(), icon_of(action), words};
  look.left_aligned = words;
  look.weight = weight;
  if (!icon_button(context, label != nullptr ? label : own.c_str(), look)) return false;
  context.actions.run(action);
  return true;
}

bool begin_panel(PanelContext& context, const char* name, const Area& area, bool scrolls) {
  // Edges on whole px, so that neighbours leave no line between them.
  const auto edge = [](double at) { return static_cast<float>(std::floor(at)); };
  ImGui::SetNextWindowPos({edge(area.left), edge(area.top)});
  ImGui::SetNextWindowSize({edge(area.right) - edge(area.left), edge(area.bottom) - edge(area.top)});
  context.hits.panels.push_back(area);
  const bool shown = ImGui::Begin(name, nullptr,
                                  ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoCollapse | (scrolls ? 0 : ImGuiWindowFlags_NoScrollbar) |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
  if (scrolls) scrolls_by_drag(context);
  return shown;
}

void end_panel() { ImGui::End(); }

void scrolls_by_drag(PanelContext& context) {
  if (ImGui::GetScrollMaxY() <= 0) return;
  const ImGuiID id = ImGui::GetID("scrolls");
  const ImVec2 from = ImGui::GetWindowPos();
  // Its bar is dragged the other way.
  context.scrolls.push_back({{from.x, from.y, from.x + ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize,
                              from.y + ImGui::GetWindowHeight()},
                             id});
  if (!context.scrolled || context.scrolled->first != id) return;
  const float to = ImGui::GetScrollY() - static_cast<float>(context.scrolled->second);
  ImGui::SetScrollY(std::clamp(to, 0.0F, ImGui::GetScrollMaxY()));
}

void holds_presses(PanelContext& context) {
  if (ImGui::GetScrollMaxY() > 0) return;
  const ImVec2 from = ImGui::GetWindowPos();
  context.scrolls.push_back(
      {{from.x, from.y, from.x + ImGui::GetWindowWidth(), from.y + ImGui::GetWindowHeight()}, ImGui::GetID("scrolls")});
}

void begin_list(PanelContext& context, const char* name, const ImVec2& size, bool border) {
  ImGui::BeginChild(name, size, border);
  scrolls_by_drag(context);
}

PictureRow picture_row(const PanelContext& context, float widest, float height) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float room = ImGui::GetWindowWidth() - 2 * ImGui::GetCursorStartPos().x - style.ScrollbarSize;
  const float line = ImGui::GetFontSize() + context.gap;
  constexpr int k_most_across = 8;
  PictureRow row{0, 0};
  do {
    ++row.across;
    row.width = (room - static_cast<float>(row.across - 1) * style.ItemSpacing.x) / static_cast<float>(row.across);
  } while (row.across < k_most_across && (row.width > widest || row.width + line > height));
  return row;
}

bool begin_dialog(PanelContext& context, const char* title, float width_units) {
  const auto window = context.window;
  const ImVec2 size{static_cast<float>(window.width), static_cast<float>(window.height)};
  context.hits.all = true;
  // Everything behind it lies in shade.
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, vec_of(k_canvas_colors.shade, k_shade));
  ImGui::Begin("shade", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoMove);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
  const float width = std::min(width_units * context.unit, size.x - 2 * context.gap);
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, size.y - 2 * context.gap});
  ImGui::SetNextWindowFocus();
  bool stays = true;
  ImGui::PushFont(title_font());
  const bool shown = ImGui::Begin(title, &stays,
                                  ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  context.scrolls.clear();
  scrolls_by_drag(context);
  // A font is pushed and popped in one window.
  ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[0]);
  // The cross does what Escape does.
  if (!stays) context.cancels = true;
  const ImVec2 from = ImGui::GetWindowPos();
  const ImVec2 to{from.x + ImGui::GetWindowWidth(), from.y + ImGui::GetWindowHeight()};
  context.dialog_area = {from.x, from.y, to.x, to.y};
  return shown;
}

void end_dialog() {
  ImGui::PopFont();
  ImGui::End();
  ImGui::PopFont();
}

bool begin_menu(PanelContext& context, const char* name) {
  if (!ImGui::BeginPopup(name)) return false;
  context.hits.all = true;
  context.menu_open = true;
  context.menu_scrolls.clear();
  std::swap(context.scrolls, context.menu_scrolls);
  scrolls_by_drag(context);
  std::swap(context.scrolls, context.menu_scrolls);
  if (context.cancels) ImGui::CloseCurrentPopup();
  return true;
}

bool control_slider(PanelContext& context, const char* id, double& value, double least, double most,
                    const SliderLook& look, bool& released) {
  const float unit = context.unit;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (unit - ImGui::GetFontSize())});
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 0.12F * unit);
  ImGui::SetNextItemWidth(look.width);
  ImGui::BeginDisabled(look.locked);
  const bool moved = ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &least, &most, "", ImGuiSliderFlags_NoInput);
  released = ImGui::IsItemDeactivatedAfterEdit();
  ImGui::PopStyleVar(2);
  note(context, ("slider " + look.name).c_str());
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto x_of = [&](double at) {
    const double share = most > least ? std::clamp((at - least) / (most - least), 0.0, 1.0) : 0.0;
    return from.x + 3 + static_cast<float>(share) * (to.x - from.x - 6);
  };
  const float rest = x_of(look.rest);
  const float now = x_of(value);
  list.AddRectFilled({std::min(rest, now), from.y + 1}, {std::max(rest, now), to.y - 1},
                     ImGui::GetColorU32(ImGuiCol_SliderGrab, 0.35F));
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.2f", value);
  const float pad = 0.3F * unit;
  const bool under_pen = ImGui::IsItemHovered() || ImGui::IsItemActive();
  const bool numbered = look.numbered && !look.locked && (!look.shy || look.changes || under_pen);
  const float wide = numbered ? ImGui::CalcTextSize(number.data()).x : 0;
  const float y = 0.5F * (from.y + to.y - ImGui::GetFontSize());
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  list.AddText({from.x + pad, y}, ink, fitted_text(look.shown, to.x - from.x - wide - 3 * pad).c_str());
  if (numbered) list.AddText({to.x - pad - wide, y}, ink, number.data());
  ImGui::EndDisabled();
  if (look.locked)
    draw_padlock(list, {to.x - pad, 0.5F * (from.y + to.y)}, unit, true, ImGui::GetColorU32(ImGuiCol_Text));
  return moved && !look.locked;
}

bool tall_slider(PanelContext& context, const char* id, double& value, double least, double most, float width,
                 const std::string& name, bool& released) {
  return control_slider(context, id, value, least, most, {width, name, name, std::max(least, std::min(0.0, most))},
                        released);
}

}  // namespace penpose::app
