#include "ui/app/widgets/internal/theme.h"

#include <cstdint>

namespace penpose::app {
namespace {

ImVec4 rgb(std::uint32_t color, float alpha = 1) {
  const auto part = [&](int shift) { return static_cast<float>((color >> shift) & 255U) / 255.0F; };
  return {part(16), part(8), part(0), alpha};
}

/// The few colours that a look is made of.
struct Palette {
  std::uint32_t panel;
  std::uint32_t field;  ///< what is dragged or typed into
  std::uint32_t button;
  std::uint32_t hovered;
  std::uint32_t accent;  ///< what is on
  std::uint32_t ink;
  std::uint32_t faint;
  std::uint32_t line;
  std::uint32_t popup;
};

// Greys of one hue with a single accent; ink on panel has a contrast above 11, faint ink one above 4.5 (WCAG 2.1).
constexpr Palette k_dark{0x1b1e23, 0x272b32, 0x2d323a, 0x3a414c, 0x2f7fd6, 0xe7eaee, 0x98a1ad, 0x3a414c, 0x23272d};
constexpr Palette k_light{0xf4f5f7, 0xe4e8ec, 0xe2e6eb, 0xd2d9e1, 0x1f6fc4, 0x1a1d21, 0x5c6672, 0xcfd6dd, 0xffffff};

}  // namespace

ImGuiStyle theme_style(bool light, float scale) {
  ImGuiStyle style;
  if (light) {
    ImGui::StyleColorsLight(&style);
  } else {
    ImGui::StyleColorsDark(&style);
  }
  const Palette& p = light ? k_light : k_dark;
  auto& colors = style.Colors;
  colors[ImGuiCol_Text] = rgb(p.ink);
  colors[ImGuiCol_TextDisabled] = rgb(p.faint);
  colors[ImGuiCol_WindowBg] = rgb(p.panel);
  colors[ImGuiCol_ChildBg] = rgb(p.panel, 0);
  colors[ImGuiCol_PopupBg] = rgb(p.popup);
  colors[ImGuiCol_Border] = rgb(p.line);
  colors[ImGuiCol_FrameBg] = rgb(p.field);
  colors[ImGuiCol_FrameBgHovered] = rgb(p.hovered);
  colors[ImGuiCol_FrameBgActive] = rgb(p.hovered);
  colors[ImGuiCol_TitleBg] = rgb(p.popup);
  colors[ImGuiCol_TitleBgActive] = rgb(p.popup);
  colors[ImGuiCol_TitleBgCollapsed] = rgb(p.popup);
  colors[ImGuiCol_Button] = rgb(p.button);
  colors[ImGuiCol_ButtonHovered] = rgb(p.hovered);
  colors[ImGuiCol_ButtonActive] = rgb(p.accent);
  colors[ImGuiCol_SliderGrab] = rgb(p.accent);
  colors[ImGuiCol_SliderGrabActive] = rgb(p.accent);
  colors[ImGuiCol_Separator] = rgb(p.line);
  colors[ImGuiCol_ScrollbarBg] = rgb(p.panel, 0);
  colors[ImGuiCol_ScrollbarGrab] = rgb(p.hovered);
  colors[ImGuiCol_ScrollbarGrabHovered] = rgb(p.faint);
  colors[ImGuiCol_ScrollbarGrabActive] = rgb(p.accent);
  colors[ImGuiCol_TextSelectedBg] = rgb(p.accent, 0.45F);
  colors[ImGuiCol_PlotHistogram] = rgb(p.accent, light ? 0.45F : 1.0F);  // under dark words
  style.DisabledAlpha = 0.45F;
  style.WindowRounding = 0;
  style.PopupRounding = 6;
  style.FrameRounding = 5;
  style.GrabRounding = 2;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.ScrollbarSize = 16;
  style.ItemSpacing = {6, 6};
  style.WindowPadding = {6, 6};
  style.FramePadding = {8, 6};
  style.ScaleAllSizes(scale);
  // A line of status is lower than ImGui's least window, which would lie over the panel below it.
  style.WindowMinSize = {1, 1};
  return style;
}

namespace {

ImFont* font_at(int place) {
  const auto& fonts = ImGui::GetIO().Fonts->Fonts;
  return fonts.Size > place ? fonts[place] : fonts[0];
}

}  // namespace

ImFont* small_font() { return font_at(1); }
ImFont* title_font() { return font_at(2); }

ImVec4 chosen_ink() { return {1, 1, 1, 1}; }

}  // namespace penpose::app
