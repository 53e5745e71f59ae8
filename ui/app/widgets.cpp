#include "ui/app/widgets.h"

#include <algorithm>
#include <imgui_stdlib.h>
#include <string_view>
#include <utility>

namespace penpose::app {
namespace {

constexpr float k_pi = 3.14159265F;

/// Puts the cursor at the end of a field that has just taken the keyboard; of a file's name all but its ending is
/// chosen, so that typing writes another name.
int place_cursor(ImGuiInputTextCallbackData* data) {
  auto& placed = *static_cast<bool*>(data->UserData);
  if (std::exchange(placed, true)) return 0;
  const std::string_view text(data->Buf, static_cast<std::size_t>(data->BufTextLen));
  const std::size_t dot = text.rfind('.');
  const bool file = dot != std::string_view::npos && dot > 0 && dot + 4 == text.size() && text[dot + 1] >= 'a';
  data->CursorPos = file ? static_cast<int>(dot) : data->BufTextLen;
  data->SelectionStart = file ? 0 : data->CursorPos;
  data->SelectionEnd = data->CursorPos;
  return 0;
}

/// A name in a format of printf.
std::string escaped(std::string_view name) {
  std::string out;
  for (const char c : name) out += c == '%' ? std::string("%%") : std::string(1, c);
  return out;
}

}  // namespace

void note(PanelContext& context, const char* label) {
  if (!ImGui::IsItemVisible()) return;
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 most = ImGui::GetItemRectMax();
  context.targets[label] = {least.x, least.y, most.x, most.y};
}

void tooltip(const char* text) {
  if (text == nullptr || *text == 0 || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 20);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void text_beside(PanelContext& context, const char* text) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::CalcTextSize(text);
  ImGui::GetWindowDrawList()->AddText({from.x + context.gap, from.y + 0.5F * (context.unit - size.y)},
                                      ImGui::GetColorU32(ImGuiCol_Text), text);
  ImGui::Dummy({size.x + 2 * context.gap, context.unit});
}

bool wide_button(PanelContext& context, const char* label, float width, bool chosen, const char* tip) {
  if (width == 0) width = std::max(context.unit, ImGui::CalcTextSize(label, nullptr, true).x + 0.6F * context.unit);
  // What is on is seen to be on under the pen, too.
  if (chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  }
  const bool pressed = ImGui::Button(label, {width, context.unit});
  if (chosen) ImGui::PopStyleColor(2);
  note(context, label);
  tooltip(tip);
  return pressed;
}

bool lock_button(PanelContext& context, const char* label, bool locked, const char* tip) {
  const bool pressed = wide_button(context, label, context.unit, locked, tip);
  const ImVec2 least = ImGui::GetItemRectMin();
  const ImVec2 most = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(locked ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  const float unit = context.unit;
  const ImVec2 middle{0.5F * (least.x + most.x), 0.5F * (least.y + most.y)};
  const float half = 0.17F * unit;
  const float top = middle.y - 0.02F * unit;
  list.AddRectFilled({middle.x - half, top}, {middle.x + half, top + 0.27F * unit}, ink, 0.04F * unit);
  // The bow; that of an open one is turned aside.
  const float bow = 0.11F * unit;
  const float x = locked ? middle.x : middle.x + 2 * bow;
  const float foot = top - 0.06F * unit;
  list.PathLineTo({x - bow, top});
  list.PathArcTo({x, foot}, bow, k_pi, 2 * k_pi, 12);
  if (locked) list.PathLineTo({x + bow, top});
  list.PathStroke(ink, 0, 0.06F * unit);
  return pressed;
}

bool action_button(PanelContext& context, Action action, float width, bool chosen, const char* label) {
  const std::string own(info(action).label);
  const std::string tip = tooltip_of(action);
  if (!wide_button(context, label != nullptr ? label : own.c_str(), width, chosen, tip.c_str())) return false;
  context.app.do_action(action);
  return true;
}

bool begin_panel(PanelContext& context, const char* name, const Area& area, bool scrolls) {
  ImGui::SetNextWindowPos({static_cast<float>(area.left), static_cast<float>(area.top)});
  ImGui::SetNextWindowSize({static_cast<float>(area.width()), static_cast<float>(area.height())});
  context.app.hits().panels.push_back(area);
  return ImGui::Begin(name, nullptr,
                      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                          (scrolls ? 0 : ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                          ImGuiWindowFlags_NoNav);
}

void end_panel() { ImGui::End(); }

bool begin_dialog(PanelContext& context, const char* title, float width_units) {
  const auto window = context.app.window();
  const ImVec2 size{static_cast<float>(window.width), static_cast<float>(window.height)};
  context.app.hits().all = true;
  // Everything behind it lies in shade.
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(0, 0, 0, 100));
  ImGui::Begin("shade", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoMove);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
  const float width = std::min(width_units * context.unit, size.x - 2 * context.gap);
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, size.y - 2 * context.gap});
  ImGui::SetNextWindowFocus();
  const bool shown = ImGui::Begin(title, nullptr,
                                  ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  const ImVec2 from = ImGui::GetWindowPos();
  const ImVec2 to{from.x + ImGui::GetWindowWidth(), from.y + ImGui::GetWindowHeight()};
  context.dialog_area = {from.x, from.y, to.x, to.y};
  return shown;
}

void end_dialog() { ImGui::End(); }

void note_field(PanelContext& context, const char* label) {
  note(context, label);
  if (ImGui::IsItemActive()) context.typed_into = context.targets[label];
}

bool begin_menu(PanelContext& context, const char* name) {
  if (!ImGui::BeginPopup(name)) return false;
  context.app.hits().all = true;
  context.menu_open = true;
  if (context.cancels) ImGui::CloseCurrentPopup();
  return true;
}

void dialog_field(PanelContext& context, const char* label, std::string& text, const char* hint) {
  context.has_field = true;
  if (context.field_first) {
    ImGui::SetKeyboardFocusHere();
    context.app.panels().cursor_placed = false;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint(label, hint, &text, ImGuiInputTextFlags_CallbackAlways, place_cursor,
                           &context.app.panels().cursor_placed);
  note_field(context, label);
  ImGui::PopStyleVar();
}

bool text_field(PanelContext& context, const char* label, std::string& text, float width, const char* hint,
                bool* accepted) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
  ImGui::SetNextItemWidth(width);
  const bool changed = ImGui::InputTextWithHint(label, hint, &text);
  note_field(context, label);
  if (accepted != nullptr) {
    *accepted = ImGui::IsItemDeactivated() && (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) ||
                                               ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter)));
  }
  ImGui::PopStyleVar();
  return changed;
}

bool tall_slider(PanelContext& context, const char* id, double& value, double least, double most, float width,
                 const std::string& name, bool& released) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 0.5F * context.unit);
  ImGui::SetNextItemWidth(width);
  const std::string format = escaped(name) + "  %.2f";
  const bool moved =
      ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &least, &most, format.c_str(), ImGuiSliderFlags_NoInput);
  released = ImGui::IsItemDeactivatedAfterEdit();
  ImGui::PopStyleVar(2);
  note(context, (std::string("slider ") + name).c_str());
  return moved;
}

}  // namespace penpose::app
