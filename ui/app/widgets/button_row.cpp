#include "ui/app/widgets/button_row.h"

#include <algorithm>

#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {

void ButtonRow::add(Action action, bool chosen, bool enabled, bool text, ButtonWeight weight) {
  Button button;
  button.label = std::string(info(action).label);
  button.icon = icon_of(action);
  button.tip = context_.actions.keys().tooltip_of(action);
  button.text = text || button.icon.empty();
  button.chosen = chosen;
  button.enabled = enabled && context_.actions.usable(action);
  button.weight = weight;
  button.keeps_word = weight != ButtonWeight::quiet;
  button.does = [this, action] { context_.actions.run(action); };
  add(std::move(button));
}

void ButtonRow::separate() {
  Button line;
  line.width = 1;
  line.shows = [](PanelContext& context, float width) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine({from.x, from.y + 0.2F * context.unit}, {from.x, from.y + 0.8F * context.unit},
                                        ImGui::GetColorU32(ImGuiCol_Separator));
    ImGui::Dummy({width, context.unit});
  };
  line.separates = true;
  add(std::move(line));
}

float ButtonRow::width_of(const Button& button) const {
  if (button.shows) return button.width;
  return button_width(context_, button.label.c_str(), button.icon, button.text);
}

bool ButtonRow::show_one(const Button& button, float width, bool text) {
  if (button.shows) {
    button.shows(context_, width);
    return false;
  }
  ImGui::BeginDisabled(!button.enabled);
  ButtonLook look{width, button.chosen, button.tip.c_str(), button.icon, text};
  look.weight = button.weight;
  look.left_aligned = in_menu_;
  const bool pressed = icon_button(context_, button.label.c_str(), look);
  ImGui::EndDisabled();
  if (pressed && button.does) button.does();
  return pressed;
}

float ButtonRow::show(float width) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  std::vector<float> widths;
  const auto measure = [&] {
    widths.clear();
    float all = -spacing;
    for (const Button& button : buttons_) {
      widths.push_back(width_of(button));
      all += widths.back() + spacing;
    }
    return all;
  };
  float all = measure();
  if (all > width) {
    // All of them with words or none, so that icons stand in one rhythm.
    for (Button& button : buttons_) button.text = button.text && (button.icon.empty() || button.keeps_word);
    all = measure();
  }
  // Room for the menu is needed only where not all fits.
  const float room = all <= width ? width : width - context_.unit - spacing;
  std::size_t shown = 0;
  float used = 0;
  while (shown < buttons_.size() && used + widths[shown] <= room) {
    if (shown > 0) ImGui::SameLine();
    show_one(buttons_[shown], widths[shown], buttons_[shown].text);
    used += widths[shown++] + spacing;
  }
  if (shown == buttons_.size()) return std::max(0.0F, used - spacing);
  if (shown > 0) ImGui::SameLine();
  const std::string more = std::string("More##") + name_;
  if (quiet_icon(context_, more.c_str(), icon::k_more, "More buttons")) ImGui::OpenPopup(name_);
  if (begin_menu(context_, name_)) {
    in_menu_ = true;
    for (; shown < buttons_.size(); ++shown) {
      if (buttons_[shown].separates) continue;
      if (show_one(buttons_[shown], std::max(widths[shown], 6 * context_.unit), true)) ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  return used + context_.unit;
}

}  // namespace penpose::app
