#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "ui/app/widgets/internal/widgets.h"

// Text that is cut where it has no room.

namespace penpose::app {

std::string fitted_text(std::string_view text, float width) {
  const auto wide = [](std::string_view part) { return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x; };
  if (wide(text) <= width) return std::string(text);
  constexpr std::string_view k_ellipsis = "\u2026";
  std::size_t end = text.size();
  const float room = width - wide(k_ellipsis);
  while (end > 0 && wide(text.substr(0, end)) > room) {
    --end;
    // Not in the middle of a letter.
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  }
  return std::string(text.substr(0, end)) + std::string(k_ellipsis);
}

std::string fitted_name(std::string_view name, float width) {
  for (const auto& [side, sign] : {std::pair<std::string_view, std::string_view>{", left", " L"}, {", right", " R"}}) {
    if (!name.ends_with(side) || ImGui::CalcTextSize(name.data(), name.data() + name.size()).x <= width) continue;
    const float end = ImGui::CalcTextSize(sign.data(), sign.data() + sign.size()).x;
    return fitted_text(name.substr(0, name.size() - side.size()), width - end) + std::string(sign);
  }
  return fitted_text(name, width);
}

void text_line(PanelContext& context, std::string_view text, float width, ImU32 color) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const std::string shown = fitted_text(text, std::max(0.0F, width - 2 * context.gap));
  ImGui::GetWindowDrawList()->AddText({from.x + context.gap, from.y + 0.5F * (context.unit - ImGui::GetFontSize())},
                                      color, shown.c_str());
  ImGui::Dummy({std::max(1.0F, width), context.unit});
}

void text_beside(PanelContext& context, const char* text) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::CalcTextSize(text);
  ImGui::GetWindowDrawList()->AddText({from.x + context.gap, from.y + 0.5F * (context.unit - size.y)},
                                      ImGui::GetColorU32(ImGuiCol_Text), text);
  ImGui::Dummy({size.x + 2 * context.gap, context.unit});
}

}  // namespace penpose::app
