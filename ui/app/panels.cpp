#include "ui/app/panels.h"

#include <algorithm>
#include <cfloat>

#include "core/document/pose_problem.h"
#include "ui/app/widgets.h"

// The toolbar, the top bar, notices and the radial menu.

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
  const double now = context.app.workspace().document().hand;
  std::size_t is = 0;
  while (is + 1 < std::size(k_hands) && k_hands[is].unsteadiness < now) ++is;
  const char* tip = "How steady the hand is: what a line strays by is not taken for a wish. Press for the next";
  if (wide_button(context, k_hands[is].label, -1, now != 1.0, tip))
    context.app.workspace().perform(document::SetHand{k_hands[(is + 1) % std::size(k_hands)].unsteadiness});
}

}  // namespace

void show_toolbar(PanelContext& context, const Area& area) {
  if (begin_panel(context, "tools", area, true)) {
    const drawing::ToolKind kind = context.app.workspace().editor().tool().kind;
    for (const ToolButton& tool : k_tools) {
      if (tool.kind == drawing::ToolKind::articulate) ImGui::Dummy({1, context.gap});
      action_button(context, tool.action, -1, kind == tool.kind);
    }
    ImGui::Dummy({1, context.gap});
    action_button(context, Action::clear_curves, -1);
    action_button(context, Action::reset_pose, -1);
    show_suggest_button(context);
    const bool weighted = context.app.workspace().document().pressure_weighting;
    if (wide_button(context, "Pressure", -1, weighted, "A target pulls harder where the pen pressed harder")) {
      context.app.workspace().perform(document::SetPressureWeighting{!weighted});
    }
    show_hand_button(context);
  }
  end_panel();
}

void show_top_bar(PanelContext& context, const Area& area) {
  App& app = context.app;
  if (begin_panel(context, "top", area)) {
    if (wide_button(context, "Menu", 0, false, "Files, settings and sessions")) ImGui::OpenPopup("menu");
    const float below = static_cast<float>(app.window().height - area.bottom);
    ImGui::SetNextWindowPos({context.gap, static_cast<float>(area.bottom)});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, std::max(below, 3 * context.unit)});
    // A menu may reach over the canvas: while it is open nothing else is hit.
    if (begin_menu(context, "menu")) {
      const auto entry = [&](const char* label, const std::string& tip) {
        const bool pressed = wide_button(context, label, 9 * context.unit, false, tip.c_str());
        if (pressed) ImGui::CloseCurrentPopup();
        return pressed;
      };
      for (const Action action : {Action::open, Action::recent, Action::save, Action::save_as, Action::export_as}) {
        if (entry(std::string(info(action).label).c_str(), tooltip_of(action))) app.do_action(action);
      }
      if (entry("Sessions", "What was drawn before, to play or to go on with")) app.panels().dialog = Dialog::sessions;
      if (entry("Tablet", "The area and the pressure of the tablet")) app.panels().dialog = Dialog::tablet;
      if (entry("Tablet keys", "What the keys and rings of the tablet and the pen's buttons do"))
        app.panels().dialog = Dialog::pad;
      if (entry("Pen menu", "What the menu around the pen offers")) app.panels().dialog = Dialog::radial;
      if (app.panels().has_keyboard && entry("Screen keyboard", "Show keys on the screen while a name is typed")) {
        app.panels().has_keyboard = false;
      }
      const char* theme = app.settings().light ? "Dark colours" : "Light colours";
      if (entry(theme, "")) app.do_action(Action::theme);
      for (const Action action : {Action::fullscreen, Action::larger, Action::smaller, Action::help, Action::quit}) {
        if (entry(std::string(info(action).label).c_str(), tooltip_of(action))) app.do_action(action);
      }
      ImGui::EndPopup();
    }
    ImGui::SameLine();
    const document::History& history = app.workspace().editor().history();
    ImGui::BeginDisabled(history.undo_count() == 0);
    action_button(context, Action::undo);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(history.redo_count() == 0);
    action_button(context, Action::redo);
    ImGui::EndDisabled();
    for (const Action action : {Action::view_front, Action::view_three_quarter, Action::view_side, Action::frame_all}) {
      ImGui::SameLine();
      action_button(context, action);
    }
    ImGui::SameLine();
    action_button(context, Action::wireframe, 0, app.panels().wireframe);
    ImGui::SameLine();
    action_button(context, Action::panels);
    ImGui::SameLine();
    const float radius = 0.16F * context.unit;
    const ImVec2 middle{static_cast<float>(area.right) - 0.7F * context.unit, 0.5F * static_cast<float>(area.height())};
    ImGui::PushClipRect({0, 0}, {middle.x - 2 * radius, static_cast<float>(area.bottom)}, true);
    text_beside(context, app.hint().c_str());
    ImGui::PopClipRect();
    // The recording light.
    ImGui::GetWindowDrawList()->AddCircleFilled(
        middle, radius, app.recording() ? IM_COL32(225, 60, 50, 255) : IM_COL32(120, 120, 120, 255));
    ImGui::SetCursorScreenPos({middle.x - 0.5F * context.unit, middle.y - 0.5F * context.unit});
    ImGui::Dummy({context.unit, context.unit});
    tooltip(app.recording() ? ("Recorded as it happens: " + app.session_path()).c_str()
                            : "This session is not recorded");
  }
  end_panel();
}

namespace {

/// Whether what is left of the last target is what a hand leaves.
bool within_hand(const Workspace& workspace) {
  return workspace.left_px() <=
         2.0 * document::hand_px(workspace.document(), workspace.editor().view().viewport, drawing::k_rules);
}

std::string why_nothing_moved(const Workspace& workspace) {
  if (within_hand(workspace)) return "the curve already is where the line was drawn";
  return workspace.document().locked.empty() ? "no control of this model brings the curve to the line"
                                             : "no control that is not locked brings the curve to the line";
}

}  // namespace

void show_notices(PanelContext& context) {
  const auto& notices = context.app.notices();
  const auto& movements = context.app.workspace().movements();
  const Area free = context.app.free_area();
  // What a dialog has to tell is not to lie in its shade.
  const bool dialog = context.app.panels().dialog != Dialog::none;
  ImDrawList& list = dialog ? *ImGui::GetForegroundDrawList() : *ImGui::GetBackgroundDrawList();
  const bool light = context.app.settings().light;
  const ImU32 back = light ? IM_COL32(250, 250, 250, 225) : IM_COL32(24, 26, 30, 225);
  const ImU32 ink = light ? IM_COL32(20, 20, 20, 255) : IM_COL32(235, 235, 235, 255);
  const ImU32 wrong = light ? IM_COL32(170, 30, 20, 255) : IM_COL32(255, 150, 120, 255);
  float y = static_cast<float>(free.bottom) - context.gap;
  const float x = static_cast<float>(free.left) + context.gap;
  const float width = std::min(static_cast<float>(free.width()) - 2 * context.gap, 26 * context.unit);
  const auto line = [&](const std::string& text, ImU32 color) {
    const float pad = context.gap;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width - 2 * pad);
    y -= size.y + 2 * pad;
    list.AddRectFilled({x, y}, {x + size.x + 2 * pad, y + size.y + 2 * pad}, back, 4);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {x + pad, y + pad}, color, text.c_str(), nullptr,
                 width - 2 * pad);
    y -= context.gap;
  };
  for (auto it = notices.rbegin(); it != notices.rend(); ++it) line(it->text, it->is_error ? wrong : ink);
  const auto tool = context.app.workspace().editor().tool().kind;
  const bool nothing_moved = movements.empty() && context.app.workspace().last_is_solved();
  if (dialog || (movements.empty() && !nothing_moved) || context.app.workspace().document().curves.empty() ||
      tool == drawing::ToolKind::articulate) {
    return;
  }
  std::string text = nothing_moved ? "nothing moved: " + why_nothing_moved(context.app.workspace()) : "moved";
  constexpr std::size_t k_named = 4;
  for (std::size_t i = 0; i < std::min(k_named, movements.size()); ++i) {
    char number[32];
    std::snprintf(number, sizeof number, "%+.2f", movements[i].by);
    text += (i == 0 ? " " : ", ") + movements[i].name + " " + number + (movements[i].at_limit ? " (its limit)" : "");
  }
  if (movements.size() > k_named) text += " and " + std::to_string(movements.size() - k_named) + " more";
  if (const double left = context.app.workspace().left_px(); left >= 0) {
    char number[32];
    std::snprintf(number, sizeof number, "; %.1f px left", left);
    text += number;
    const bool short_of_it =
        std::any_of(movements.begin(), movements.end(), [](const auto& one) { return one.at_limit; });
    if (short_of_it && !within_hand(context.app.workspace())) text += ", beyond what the control can";
  }
  line(text, ink);
}

void show_radial_menu(PanelContext& context) {
  auto& middle = context.app.panels().radial;
  if (!middle) return;
  const auto window = context.app.window();
  context.app.hits().all = true;
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
  const Area free = context.app.free_area();
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
      const Action action = context.app.settings().radial[static_cast<std::size_t>(i)];
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
  const auto* curve = chosen ? document::find_curve(app.workspace().document(), chosen->first) : nullptr;
  if (curve == nullptr || app.workspace().editor().tool().kind != drawing::ToolKind::none) {
    app.panels().curve_menu.reset();
    return;
  }
  const bool reference = curve->role == document::PoseCurveRole::reference;
  const float width = 3 * context.unit;
  const double rows = 1 + (reference ? 1 : 0) + (curve->target ? 1 : 0);
  const double height = rows * (context.unit + static_cast<double>(ImGui::GetStyle().ItemSpacing.y)) + context.gap;
  const double wide = static_cast<double>(width) + 2 * context.gap;
  const Area free = app.free_area();
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
      app.workspace().set_tool(tool);
      done = true;
    }
    if (reference && wide_button(context, "Keep##curve", -1, false, tooltip_of(Action::keep_curve).c_str())) {
      app.workspace().perform(document::KeepCurve{id});
      done = true;
    }
    if (wide_button(context, "Delete##curve", -1, false, tooltip_of(Action::delete_curve).c_str())) {
      app.workspace().perform(document::DeleteCurve{id});
      done = true;
    }
  }
  end_panel();
  if (done) app.panels().curve_menu.reset();
}

}  // namespace penpose::app
