#include "ui/app/panels/panels.h"

#include <algorithm>
#include <cfloat>
#include <initializer_list>

#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// The toolbar, the top bar and the radial menu.

namespace penpose::app {
namespace {

struct ToolButton {
  Action action;
  drawing::ToolKind kind;
};

constexpr ToolButton k_tools[] = {
    {Action::tool_pose, drawing::ToolKind::pose},
    {Action::tool_oversketch, drawing::ToolKind::oversketch},
    {Action::tool_constraint, drawing::ToolKind::constraint},
    {Action::tool_pin, drawing::ToolKind::pin},
    {Action::tool_erase, drawing::ToolKind::erase},
    {Action::tool_select, drawing::ToolKind::none},
    {Action::tool_articulate, drawing::ToolKind::articulate},
};

/// How much of what is drawn is taken for the hand and not for a wish: a press takes the next of three.
void show_hand_button(PanelContext& context) {
  struct Hand {
    const char* label;
    double unsteadiness;
  };
  constexpr Hand k_hands[] = {{"Steady", 0.5}, {"Usual hand", 1.0}, {"Unsteady", 2.0}};
  const double now = context.app.editing().document().hand;
  std::size_t is = 0;
  while (is + 1 < std::size(k_hands) && k_hands[is].unsteadiness < now) ++is;
  const char* tip = "How steady the hand is: what a line strays by is not taken for a wish. Press for the next";
  if (wide_button(context, k_hands[is].label, -1, now != 1.0, tip))
    context.app.editing().perform(document::SetHand{k_hands[(is + 1) % std::size(k_hands)].unsteadiness});
}

}  // namespace

void show_toolbar(PanelContext& context, const Area& area) {
  if (begin_panel(context, "tools", area, true)) {
    const drawing::ToolKind kind = context.app.editing().editor().tool().kind;
    for (const ToolButton& tool : k_tools) {
      if (tool.kind == drawing::ToolKind::articulate) ImGui::Dummy({1, context.gap});
      action_button(context, tool.action, -1, kind == tool.kind);
    }
    ImGui::Dummy({1, context.gap});
    action_button(context, Action::clear_curves, -1);
    action_button(context, Action::reset_pose, -1);
    show_suggest_button(context);
    const bool weighted = context.app.editing().document().pressure_weighting;
    if (wide_button(context, "Pressure", -1, weighted, "A target pulls harder where the pen pressed harder")) {
      context.app.editing().perform(document::SetPressureWeighting{!weighted});
    }
    show_hand_button(context);
  }
  end_panel();
}

namespace {

/// A line between two groups of a menu's column.
void rule(const PanelContext& context) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine(from, {from.x + 9 * context.unit, from.y},
                                      ImGui::GetColorU32(ImGuiCol_Separator));
  ImGui::Dummy({9 * context.unit, 1});
}

/// All that is neither a tool nor of the timeline, in groups.
void show_menu(PanelContext& context, const Area& bar) {
  App& app = context.app;
  const float below = static_cast<float>(app.canvas().window().height - bar.bottom);
  ImGui::SetNextWindowPos({context.gap, static_cast<float>(bar.bottom)});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, std::max(below, 3 * context.unit)});
  // A menu may reach over the canvas: while it is open nothing else is hit.
  if (!begin_menu(context, "menu")) return;
  const auto entry = [&](const char* label, std::string_view drawn, const char* tip) {
    const bool pressed = menu_entry(context, label, drawn, {}, tip);
    if (pressed) ImGui::CloseCurrentPopup();
    return pressed;
  };
  const auto actions = [&](std::initializer_list<Action> group) {
    for (const Action action : group) {
      const std::string label = action == Action::theme
                                    ? app.preferences().settings().light ? "Dark colours" : "Light colours"
                                    : std::string(info(action).label);
      const std::string key = shortcut_text(info(action).key);
      if (!menu_entry(context, label.c_str(), icon_of(action), key, std::string(info(action).tip).c_str())) continue;
      ImGui::CloseCurrentPopup();
      app.do_action(action);
    }
  };
  // Two columns, so that it ends above the window's foot.
  ImGui::BeginGroup();
  actions(
      {Action::open, Action::recent, Action::save, Action::save_as, Action::export_as, Action::film, Action::backdrop});
  if (entry("Sessions", icon::k_session, "What was drawn before, to play or to go on with")) {
    app.dialogs().show(Dialog::sessions);
  }
  rule(context);
  actions({Action::set_front, Action::history, Action::library, Action::flip_pose, Action::copy_to_right,
           Action::copy_to_left});
  ImGui::EndGroup();
  ImGui::SameLine();
  ImGui::BeginGroup();
  actions({Action::stabiliser, Action::density, Action::theme, Action::larger, Action::smaller, Action::fullscreen});
  rule(context);
  if (entry("Tablet", icon::k_tablet, "The area and the pressure of the tablet")) app.dialogs().show(Dialog::tablet);
  if (entry("Tablet keys", icon::k_keys, "What the keys and rings of the tablet and the pen's buttons do"))
    app.dialogs().show(Dialog::pad);
  if (entry("Pen menu", icon::k_radial, "What the menu around the pen offers")) app.dialogs().show(Dialog::radial);
  if (app.panels().has_keyboard &&
      entry("Screen keyboard", icon_of(Action::shortcuts), "Show keys on the screen while a name is typed")) {
    app.panels().has_keyboard = false;
  }
  rule(context);
  actions({Action::search, Action::shortcuts, Action::help, Action::quit});
  ImGui::EndGroup();
  ImGui::EndPopup();
}

}  // namespace

void show_top_bar(PanelContext& context, const Area& area) {
  App& app = context.app;
  if (begin_panel(context, "top", area)) {
    if (icon_button(context, "Menu", {0, false, "Files, settings and sessions", icon::k_menu})) {
      ImGui::OpenPopup("menu");
    }
    show_menu(context, area);
    ImGui::SameLine();
    const float radius = 0.16F * context.unit;
    const ImVec2 middle{static_cast<float>(area.right) - 0.7F * context.unit, 0.5F * static_cast<float>(area.height())};
    ButtonRow row(context, "more views");
    // Icons that everybody knows stand alone.
    row.add(Action::undo, false, true, false);
    row.add(Action::redo, false, true, false);
    row.add(Action::history, false, true, false);
    for (const Action action : {Action::view_front, Action::view_three_quarter, Action::view_side}) row.add(action);
    row.add(Action::frame_all, false, true, false);
    row.add(Action::flat_view, app.canvas().flat(), true, false);
    row.add(Action::mirror_strokes, app.playback().while_drawing().mirrors);
    row.add(Action::search, false, true, false);
    row.add(Action::wireframe, app.canvas().look().wireframe, true, false);
    row.add(Action::panels);
    // What to do next is worth a third of the bar.
    const float room = ImGui::GetContentRegionAvail().x - 1.2F * context.unit;
    row.show(room - std::min(0.3F * room, ImGui::CalcTextSize(app.hint().c_str()).x + 3 * context.gap));
    ImGui::SameLine();
    text_line(context, app.hint(), middle.x - 2 * radius - ImGui::GetCursorScreenPos().x,
              ImGui::GetColorU32(ImGuiCol_Text));
    tooltip(context, app.hint().c_str());
    // The recording light.
    ImGui::GetWindowDrawList()->AddCircleFilled(
        middle, radius, app.recording() ? IM_COL32(225, 60, 50, 255) : IM_COL32(120, 120, 120, 255));
    ImGui::SetCursorScreenPos({middle.x - 0.5F * context.unit, middle.y - 0.5F * context.unit});
    ImGui::Dummy({context.unit, context.unit});
    tooltip(context, app.recording() ? ("Recorded as it happens: " + app.session_path()).c_str()
                                     : "This session is not recorded");
  }
  end_panel();
}

void show_radial_menu(PanelContext& context) {
  auto& middle = context.app.panels().radial;
  if (!middle) return;
  const auto window = context.app.canvas().window();
  context.app.canvas().hits().all = true;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({static_cast<float>(window.width), static_cast<float>(window.height)});
  ImGui::SetNextWindowBgAlpha(0.25F);
  ImGui::SetNextWindowFocus();
  const float width = 2.4F * context.unit;
  const float reach = 2.9F * context.unit;
  // All of it stays on the canvas, or at least in the window where that is too small.
  const auto within = [](double at, double margin, double least, double most, double all) {
    const bool fits = most - least >= 2 * margin;
    const double from = (fits ? least : 0) + margin;
    return static_cast<float>(std::clamp(at, from, std::max(from, (fits ? most : all) - margin)));
  };
  const Area free = context.app.canvas().free_area();
  const double margin_x = static_cast<double>(reach + 0.5F * width + context.gap);
  const double margin_y = static_cast<double>(reach + 0.5F * context.unit + context.gap);
  const float x = within(middle->x, margin_x, free.left, free.right, window.width);
  const float y = within(middle->y, margin_y, free.top, free.bottom, window.height);
  bool close = false;
  if (ImGui::Begin("radial", nullptr,
                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    constexpr float k_places[8][2] = {{0, -1}, {0.8F, -0.55F}, {1, 0},  {0.8F, 0.55F},
                                      {0, 1},  {-0.8F, 0.55F}, {-1, 0}, {-0.8F, -0.55F}};
    for (int i = 0; i < 8; ++i) {
      ImGui::SetCursorPos(
          {x + reach * k_places[i][0] - 0.5F * width, y + reach * k_places[i][1] - 0.5F * context.unit});
      ImGui::PushID(i);
      const Action action = context.app.preferences().settings().radial[static_cast<std::size_t>(i)];
      const std::string label = std::string(info(action).label) + "##radial";
      if (wide_button(context, label.c_str(), width)) {
        context.app.do_action(action);
        close = true;
      }
      ImGui::PopID();
    }
    if (!close && ImGui::IsMouseClicked(0) && !ImGui::IsAnyItemHovered()) close = true;
  }
  ImGui::End();
  if (close) middle.reset();
}

void show_curve_menu(PanelContext& context) {
  App& app = context.app;
  const auto chosen = app.panels().curve_menu;
  const auto* curve = chosen ? document::find_curve(app.editing().document(), chosen->first) : nullptr;
  if (curve == nullptr || app.editing().editor().tool().kind != drawing::ToolKind::none) {
    app.panels().curve_menu.reset();
    return;
  }
  const bool reference = curve->role == document::PoseCurveRole::reference;
  const float width = 3 * context.unit;
  const double rows = 1 + (reference ? 1 : 0) + (curve->target ? 1 : 0);
  const double height = rows * (context.unit + static_cast<double>(ImGui::GetStyle().ItemSpacing.y)) + context.gap;
  const double wide = static_cast<double>(width) + 2 * context.gap;
  const Area free = app.canvas().free_area();
  const double left = std::clamp(chosen->second.x + context.unit, free.left, std::max(free.left, free.right - wide));
  const double top = std::clamp(chosen->second.y, free.top, std::max(free.top, free.bottom - height));
  const document::CurveId id = curve->id;
  const bool target = curve->target.has_value();
  bool done = false;
  if (begin_panel(context, "curve", {left, top, left + wide, top + height})) {
    if (target && wide_button(context, "Redraw##curve", -1, false, "Draw over a part of this target")) {
      drawing::Tool tool;
      tool.kind = drawing::ToolKind::oversketch;
      tool.curve = id;
      app.editing().set_tool(tool);
      done = true;
    }
    if (reference && wide_button(context, "Keep##curve", -1, false, tooltip_of(Action::keep_curve).c_str())) {
      app.editing().perform(document::KeepCurve{id});
      done = true;
    }
    if (wide_button(context, "Delete##curve", -1, false, tooltip_of(Action::delete_curve).c_str())) {
      app.editing().perform(document::DeleteCurve{id});
      done = true;
    }
  }
  end_panel();
  if (done) app.panels().curve_menu.reset();
}

}  // namespace penpose::app
