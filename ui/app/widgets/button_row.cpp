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

std::vector<float> ButtonRow::widths() const {
  std::vector<float> widths;
  for (const Button& button : buttons_) widths.push_back(width_of(button));
  return widths;
}

float ButtonRow::sum_of(const std::vector<float>& widths, bool with_spare) const {
  float all = -ImGui::GetStyle().ItemSpacing.x;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    if (with_spare || !buttons_[i].spare) all += widths[i] + ImGui::GetStyle().ItemSpacing.x;
  }
  return all;
}

void ButtonRow::fit(std::vector<float>& widths, float width) const {
  float left = width - sum_of(widths, true);
  const bool any_spare = std::any_of(buttons_.begin(), buttons_.end(), [](const Button& one) { return one.spare; });
  // Those that are spare stand in the menu then.
  if (left < 0 && any_spare) left = width - context_.unit - ImGui::GetStyle().ItemSpacing.x - sum_of(widths, false);
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const Button& button = buttons_[i];
    if (button.least <= 0 || button.most <= 0) continue;
    const float fitted = std::clamp(widths[i] + left, button.least, button.most);
    left -= fitted - widths[i];
    widths[i] = fitted;
  }
}

float ButtonRow::show(float width) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  std::vector<float> widths = this->widths();
  if (sum_of(widths, true) > width) {
    // All of them with words or none, so that icons stand in one rhythm.
    for (Button& button : buttons_) button.text = button.text && (button.icon.empty() || button.keeps_word);
    widths = this->widths();
  }
  fit(widths, width);
  const float all = sum_of(widths, true);
  // Room for the menu is needed only where not all fits.
  const float room = all <= width ? width : width - context_.unit - spacing;
  std::size_t shown = 0;
  float used = 0;
  while (shown < buttons_.size() && used + widths[shown] <= room + 0.5F) {
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
