#pragma once

#include <imgui.h>

// The two looks of panels. Private to the module: ImGui's types show.

namespace penpose::app {

/// Colours and measures of the dark or the light look, at a scale.
[[nodiscard]] ImGuiStyle theme_style(bool light, float scale);

/// Sizes of letters, px at scale 1: of what is read at all times, of what stands beside it, and of titles.
inline constexpr float k_text_px = 16;
inline constexpr float k_small_px = 13;
inline constexpr float k_title_px = 20;

/// Letters of those sizes; the usual one where the others could not be made.
[[nodiscard]] ImFont* small_font();
[[nodiscard]] ImFont* title_font();

/// Ink on what is on (a chosen button).
[[nodiscard]] ImVec4 chosen_ink();

}  // namespace penpose::app
