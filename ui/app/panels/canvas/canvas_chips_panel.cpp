#include <algorithm>
#include <string>
#include <vector>

#include "ui/app/canvas/canvas.h"
#include "ui/app/controls/controls.h"
#include "ui/app/controls/restriction.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/performer.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// What is on at the moment, in the upper left of the canvas: a take that is performed, which controls may move, a new
// control that is seen at its target. Each has what ends it beside it.

namespace penpose::app {
namespace {

/// One line: words, and what can be pressed.
struct Chip {
  const char* name;
  std::string text;
  std::vector<Action> actions;
  bool records = false;
};

/// "12 keys, 48 frames", "1 key, 1 frame".
std::string counted(std::size_t count, const char* one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

Chip performing_chip(const Performer& performer, const std::string& key) {
  if (performer.performing())
    return {"performing", "Recording: " + counted(performer.frame_count(), "frame"), {}, true};
  if (const Take* take = performer.take())
    return {"performing",
            counted(take->keys, "key") + ", " + counted(take->frames, "frame"),
            {Action{"perform_again"}, Action{"review_take"}, Action{"keep_take"}}};
  return {"performing", "Press on the face and pull" + (key.empty() ? key : " (" + key + " ends)"), {Action::perform}};
}

/// What stands on the button of an action here, where its name says more than is needed.
std::string label_of(Action action) {
  if (action == Action{"keep_take"}) return "Keep";
  if (action == Action::perform) return "Done";
  return std::string(info(action).label);
}

float text_width(const PanelContext& context, const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x + context.gap;
}

float width_of(const PanelContext& context, const Chip& chip) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float width = text_width(context, chip.text) + 2 * style.WindowPadding.x + (chip.records ? context.unit : 0);
  for (const Action action : chip.actions)
    width += button_width(context, label_of(action).c_str(), icon_of(action), true) + style.ItemSpacing.x;
  return width;
}

/// Shows a chip; where its place ends below, px.
double show_chip(PanelContext& context, const Area& free, const Chip& chip, double top) {
  const auto gap = static_cast<double>(context.gap);
  const double left = free.left + gap;
  const auto wide = static_cast<double>(width_of(context, chip));
  const double right = std::min(free.right - gap, left + wide + 1);
  const double bottom = top + static_cast<double>(context.unit + 2 * ImGui::GetStyle().WindowPadding.y);
  if (bottom > free.bottom) return top;
  if (begin_panel(context, chip.name, {left, top, right, bottom})) {
    if (chip.records) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 0.4F * context.unit, at.y + 0.5F * context.unit},
                                                  0.22F * context.unit, color_of(palette().record));
      ImGui::Dummy({0.8F * context.unit, context.unit});
      ImGui::SameLine();
    }
    float buttons = 0;
    for (const Action action : chip.actions)
      buttons +=
          button_width(context, label_of(action).c_str(), icon_of(action), true) + ImGui::GetStyle().ItemSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x - buttons;
    text_beside(context, fitted_text(chip.text, std::max(room, 0.0F)).c_str());
    for (const Action action : chip.actions) {
      ImGui::SameLine();
      const std::string label = label_of(action) + "##" + chip.name;
      ButtonLook look{0, false, nullptr, icon_of(action)};
      const std::string tip = context.actions.keys().tooltip_of(action);
      look.tip = tip.c_str();
      if (action == Action{"keep_take"}) look.weight = ButtonWeight::primary;
      if (icon_button(context, label.c_str(), look)) context.actions.run(action);
    }
  }
  end_panel();
  return bottom + gap;
}

/// Which controls may move: a touch of it frees all.
double show_restriction(PanelContext& context, const Area& free, const std::string& words, Restriction& restriction,
                        double top) {
  const auto gap = static_cast<double>(context.gap);
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  const std::string shown = fitted_text(words, static_cast<float>(free.width()) - 3 * context.unit);
  const std::string label = shown + "##restriction";
  const auto width = static_cast<double>(button_width(context, label.c_str(), icon::k_cross, true) + 2 * padding.x);
  const double left = free.left + gap;
  const double bottom = top + static_cast<double>(context.unit + 2 * padding.y);
  if (bottom > free.bottom) return top;
  if (begin_panel(context, "restriction", {left, top, left + width + 1, bottom})) {
    if (icon_button(context, label.c_str(),
                    {0, true, "Only these controls move. Touch to let all move again", icon::k_cross}))
      restriction.lift();
    note(context, "restriction");
  }
  end_panel();
  return bottom + gap;
}

/// A red edge around the canvas.
void show_recording(const Area& free, float wide) {
  const float inset = 0.5F * wide;
  ImGui::GetBackgroundDrawList()->AddRect(
      {static_cast<float>(free.left) + inset, static_cast<float>(free.top) + inset},
      {static_cast<float>(free.right) - inset, static_cast<float>(free.bottom) - inset}, color_of(palette().record), 0,
      0, wide);
}

}  // namespace

void show_canvas_chips(PanelContext& context, const Area& free, EditingSession& editing, Playback& playback,
                       Performer& performer, ToolInHand& tool, Controls& controls, Restriction& restriction) {
  const auto& cast = context.own.of<CanvasBars>().cast;
  double top = (cast ? cast->bottom : free.top) + static_cast<double>(context.gap);
  if (performer.performing()) show_recording(free, 0.5F * context.gap);
  const bool performs = playback.while_drawing().performs;
  if (performer.performing() || (performs && tool.now().pulls) || performer.take() != nullptr) {
    const Chip chip = performing_chip(performer, context.actions.keys().shortcut_of(Action::perform));
    top = show_chip(context, free, chip, top);
  }
  // While the pen draws nothing comes under it.
  if (const std::string words = restriction.words(); !words.empty())
    top = show_restriction(context, free, words, restriction, top);
  const std::string* trial = editing.pen_is_drawing() ? nullptr : controls.trial();
  if (trial == nullptr) return;
  show_chip(context, free, {"trial", *trial + " at its target", {Action{"new_to_rest"}, Action{"new_stays"}}}, top);
}

}  // namespace penpose::app
