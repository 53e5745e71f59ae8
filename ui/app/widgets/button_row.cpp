#include "ui/app/widgets/button_row.h"

#include <algorithm>

#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {

void ButtonRow::add(Action action, bool chosen, bool enabled, bool text) {
  Button button;
  button.label = std::string(info(action).label);
  button.icon = icon_of(action);
  button.tip = context_.actions.keys().tooltip_of(action);
  button.text = text || button.icon.empty();
  button.chosen = chosen;
  button.enabled = enabled && context_.actions.usable(action);
  button.does = [this, action] { context_.actions.run(action); };
  add(std::move(button));
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
  const bool pressed = icon_button(context_, button.label.c_str(), look);
  ImGui::EndDisabled();
  if (pressed && button.does) button.does();
  return pressed;
}

float ButtonRow::show(float width) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  std::vector<float> widths;
  float all = -spacing;
  for (const Button& button : buttons_) {
    widths.push_back(width_of(button));
    all += widths.back() + spacing;
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
  if (icon_button(context_, more.c_str(), {context_.unit, false, "More buttons", icon::k_more, false})) {
    ImGui::OpenPopup(name_);
  }
  if (begin_menu(context_, name_)) {
    for (; shown < buttons_.size(); ++shown) {
      if (show_one(buttons_[shown], std::max(widths[shown], 6 * context_.unit), true)) ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  return used + context_.unit;
}

}  // namespace penpose::app
