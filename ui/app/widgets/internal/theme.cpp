#include "ui/app/widgets/internal/theme.h"

namespace penpose::app {

ImVec4 vec_of(Rgb color, float alpha) {
  const auto part = [&](int shift) { return static_cast<float>((color >> shift) & 255U) / 255.0F; };
  return {part(16), part(8), part(0), alpha};
}

ImU32 color_of(Rgb color, float alpha) { return ImGui::GetColorU32(vec_of(color, alpha)); }

const Palette& palette() { return palette_of(ImGui::GetIO().UserData == &k_light_palette); }

void use_theme(bool light, float scale) {
  ImGui::GetStyle() = theme_style(light, scale);
  ImGui::GetIO().UserData = const_cast<Palette*>(&palette_of(light));
}

float scaled(float px) { return px * ImGui::GetStyle().MouseCursorScale; }

ImGuiStyle theme_style(bool light, float scale) {
  ImGuiStyle style;
  if (light) {
    ImGui::StyleColorsLight(&style);
  } else {
    ImGui::StyleColorsDark(&style);
  }
  const Palette& p = palette_of(light);
  auto& colors = style.Colors;
  colors[ImGuiCol_Text] = vec_of(p.ink);
  colors[ImGuiCol_TextDisabled] = vec_of(p.faint);
  colors[ImGuiCol_WindowBg] = vec_of(p.panel);
  colors[ImGuiCol_ChildBg] = vec_of(p.panel, 0);
  colors[ImGuiCol_PopupBg] = vec_of(p.popup);
  colors[ImGuiCol_Border] = vec_of(p.line);
  colors[ImGuiCol_FrameBg] = vec_of(p.field);
  colors[ImGuiCol_FrameBgHovered] = vec_of(p.hovered);
  colors[ImGuiCol_FrameBgActive] = vec_of(p.hovered);
  colors[ImGuiCol_TitleBg] = vec_of(p.popup);
  colors[ImGuiCol_TitleBgActive] = vec_of(p.popup);
  colors[ImGuiCol_TitleBgCollapsed] = vec_of(p.popup);
  colors[ImGuiCol_Button] = vec_of(p.button);
  colors[ImGuiCol_ButtonHovered] = vec_of(p.hovered);
  colors[ImGuiCol_ButtonActive] = vec_of(p.accent);
  colors[ImGuiCol_SliderGrab] = vec_of(p.accent);
  colors[ImGuiCol_SliderGrabActive] = vec_of(p.accent);
  colors[ImGuiCol_Separator] = vec_of(p.line);
  colors[ImGuiCol_ScrollbarBg] = vec_of(p.panel, 0);
  colors[ImGuiCol_ScrollbarGrab] = vec_of(p.hovered);
  colors[ImGuiCol_ScrollbarGrabHovered] = vec_of(p.faint);
  colors[ImGuiCol_ScrollbarGrabActive] = vec_of(p.accent);
  colors[ImGuiCol_Header] = vec_of(p.chosen);
  colors[ImGuiCol_HeaderHovered] = colors[ImGuiCol_HeaderActive] = vec_of(p.hovered);
  colors[ImGuiCol_CheckMark] = vec_of(p.accent);
  colors[ImGuiCol_TextSelectedBg] = vec_of(p.accent, 0.45F);
  colors[ImGuiCol_PlotHistogram] = vec_of(p.accent, light ? 0.45F : 1.0F);  // under dark words
  style.DisabledAlpha = 0.45F;
  style.WindowRounding = 0;
  style.PopupRounding = k_wide_corner_px;
  style.FrameRounding = k_corner_px;
  style.GrabRounding = k_thin_corner_px;
  style.ScrollbarRounding = k_wide_corner_px;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = k_hair_px;
  style.ScrollbarSize = 16;
  style.ItemSpacing = {k_gap_px, k_gap_px};
  style.WindowPadding = {k_gap_px, k_gap_px};
  style.FramePadding = {8, k_gap_px};
  style.ScaleAllSizes(scale);
  // A line of status is lower than ImGui's least window, which would lie over the panel below it.
  style.WindowMinSize = {1, 1};
  // ImGui draws no cursor here; scaled() reads it.
  style.MouseCursorScale = scale;
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

}  // namespace penpose::app
