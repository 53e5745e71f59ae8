#include <algorithm>
#include <cstdio>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/suggestion_offer.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// The rest of the face as the keys suggest it: asked for in the toolbar, taken or dismissed beside the model.

namespace penpose::app {
namespace {

/// The first few controls that would move, a line each, and how many more there are.
std::string moved_text(EditingSession& editing, const SuggestionOffer& offer) {
  constexpr std::size_t k_named = 5;
  const auto& movements = offer.movements();
  if (movements.empty()) {
    return offer.suggestion().command.strength > 0
               ? "The keyed poses suggest no change."
               : "The keyed poses have too little in common for a reliable suggestion. "
                 "Drag the slider to see it anyway.";
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(k_named, movements.size()); ++i) {
    char number[32];
    std::snprintf(number, sizeof number, "%+.2f  ", movements[i].by);
    if (i > 0) text += '\n';
    text += number;
    text += editing.words_of(movements[i].name);
  }
  if (movements.size() > k_named) {
    text += "\nand ";
    text += std::to_string(movements.size() - k_named);
    text += " more";
  }
  return text;
}

}  // namespace

void show_suggest_button(PanelContext& context, EditingSession& editing, SuggestionOffer& offer, float width,
                         bool words) {
  const std::string& why_not = offer.why_not(editing);
  if (why_not.empty() || offer.open()) {
    tool_button(context, Action::suggest_rest, width, words, offer.open());
    return;
  }
  const std::string label(info(Action::suggest_rest).label);
  const std::string tip = context.actions.keys().tooltip_of(Action::suggest_rest) + ". Not yet: " + why_not;
  ImGui::BeginDisabled(true);
  ButtonLook look{width, false, nullptr, icon_of(Action::suggest_rest), words};
  look.left_aligned = words;
  look.weight = ButtonWeight::quiet;
  icon_button(context, label.c_str(), look);
  ImGui::EndDisabled();
  // After it, so that the reason itself is not grey.
  tooltip(context, tip.c_str());
}

void show_suggestion(PanelContext& context, const Area& /*area*/, EditingSession& editing, Canvas& canvas,
                     SuggestionOffer& offer) {
  if (!offer.open()) return;
  const Area free = canvas.free_area();
  const double width =
      std::min(7.5 * static_cast<double>(context.unit), free.width() - 2 * static_cast<double>(context.gap));
  const std::string text = moved_text(editing, offer);
  const std::string title = "Suggested by " + std::to_string(offer.suggestion().keys) + " keyed poses";
  const auto inside = static_cast<float>(width) - 2 * ImGui::GetStyle().WindowPadding.x;
  const float lines = ImGui::CalcTextSize(title.c_str(), nullptr, false, inside).y +
                      ImGui::CalcTextSize(text.c_str(), nullptr, false, inside).y;
  const double height = static_cast<double>(lines + 2 * context.unit + 3 * ImGui::GetStyle().ItemSpacing.y +
                                            2 * ImGui::GetStyle().WindowPadding.y);
  const double right = free.right - static_cast<double>(context.gap);
  const double top = free.top + static_cast<double>(context.gap);
  // Away from what is told at the bottom.
  if (begin_panel(context, "suggestion", {right - width, top, right, std::min(top + height, free.bottom)}, true)) {
    ImGui::TextWrapped("%s", title.c_str());
    double strength = offer.suggestion().command.strength;
    bool released = false;
    if (tall_slider(context, "##strength", strength, 0, 1, ImGui::GetContentRegionAvail().x, "amount", released)) {
      offer.set_strength(editing, strength);
    }
    if (offer.open()) ImGui::TextWrapped("%s", text.c_str());
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (primary_button(context, "Take it##suggestion", half, "Apply it; what you posed stays")) {
      offer.take(editing);
    }
    ImGui::SameLine();
    if (wide_button(context, "Dismiss##suggestion", half, false, "Keep the pose unchanged (Esc)")) {
      offer.dismiss(editing);
    }
  }
  end_panel();
}

}  // namespace penpose::app
