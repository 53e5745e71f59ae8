#pragma once

#include <imgui.h>

#include "ui/app/widgets/internal/tokens.h"

// The two looks of panels. Private to the module: ImGui's types show.

namespace penpose::app {

/// Colours and measures of the dark or the light look, at a scale.
[[nodiscard]] ImGuiStyle theme_style(bool light, float scale);

/// Takes that look for all panels.
void use_theme(bool light, float scale);

/// The colours of the look that was taken last.
[[nodiscard]] const Palette& palette();
/// A colour as ImGui takes it; `alpha` 0..1.
[[nodiscard]] ImVec4 vec_of(Rgb color, float alpha = 1);
[[nodiscard]] ImU32 color_of(Rgb color, float alpha = 1);
/// A picture with this has its own colours.
inline constexpr ImU32 k_untinted = IM_COL32_WHITE;

/// Converts px at scale 1 to px of the window, by the scale that use_theme took last.
[[nodiscard]] float scaled(float px);

/// Letters of the small size and of titles; the usual one where the others could not be made.
[[nodiscard]] ImFont* small_font();
[[nodiscard]] ImFont* title_font();

}  // namespace penpose::app
