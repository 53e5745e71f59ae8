#include "ui/app/widgets/internal/picture_tile.h"

#include "ui/app/widgets/internal/theme.h"

namespace penpose::app {

float picture_tile_height(const PanelContext& context, float width) {
  return width + ImGui::GetFontSize() + context.gap;
}

bool picture_tile(PanelContext& context, const char* label, const PictureTile& tile) {
  ImGui::PushID(label);
  const bool pressed = ImGui::InvisibleButton("##picture", {tile.width, picture_tile_height(context, tile.width)});
  ImGui::PopID();
  note(context, label);
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_ButtonHovered : ImGuiCol_Button),
                     5);
  if (tile.picture) {
    list.AddImageRounded(ImGui::GetIO().Fonts->TexID, {from.x + 2, from.y + 2}, {to.x - 2, from.y + tile.width - 2},
                         tile.picture->first, tile.picture->second, k_untinted, 4);
  }
  const std::string shown = fitted_text(tile.text, tile.width - context.gap);
  const float wide = ImGui::CalcTextSize(shown.c_str()).x;
  list.AddText({0.5F * (from.x + to.x - wide), from.y + tile.width + 0.25F * context.gap},
               ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
  if (tile.chosen)
    list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_ButtonActive), ImGui::GetStyle().FrameRounding, 0, scaled(2.5F));
  return pressed;
}

}  // namespace penpose::app
