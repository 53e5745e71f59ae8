#pragma once

#include <imgui.h>
#include <string_view>

#include "ui/app/action.h"

// Icons of actions, drawn as lines in any size and colour. Private to the module: ImGui's types show.

namespace penpose::app {

/// The drawing of an action's icon (icon.cpp tells the language); empty: it has none.
[[nodiscard]] inline std::string_view icon_of(Action action) { return info(action).icon; }

/// Draws one in a square of `size` px about a middle.
void draw_icon(ImDrawList& list, std::string_view icon, ImVec2 middle, float size, ImU32 color);

namespace icon {
// Of what is no action.
inline constexpr std::string_view k_menu = "M4 7L20 7M4 12L20 12M4 17L20 17";
inline constexpr std::string_view k_more = "D5 12 1.7D12 12 1.7D19 12 1.7";
inline constexpr std::string_view k_cross = "M6 6L18 18M18 6L6 18";
inline constexpr std::string_view k_pencil = "M4 20L5 15L16 4L20 8L9 19Z M13 7L17 11";
inline constexpr std::string_view k_back = "A12 13 7 -60 200M18 3L18 8L13 8";
inline constexpr std::string_view k_open = "M5 9L12 16L19 9";
inline constexpr std::string_view k_folded = "M9 5L16 12L9 19";
inline constexpr std::string_view k_plus = "M12 5L12 19M5 12L19 12";
inline constexpr std::string_view k_minus = "M5 12L19 12";
inline constexpr std::string_view k_left = "M15 5L8 12L15 19";
inline constexpr std::string_view k_right = "M9 5L16 12L9 19";
inline constexpr std::string_view k_session = "C12 12 8D12 12 3";
inline constexpr std::string_view k_tablet = "M3 6L21 6L21 18L3 18Z M8 14L16 9";
inline constexpr std::string_view k_keys = "M4 5L20 5L20 19L4 19Z M8 9L8 11M12 9L12 11M16 9L16 11M8 15L16 15";
inline constexpr std::string_view k_radial = "C12 12 8C12 12 2.5";
inline constexpr std::string_view k_stop = "M7 7L17 7L17 17L7 17F";
}  // namespace icon

}  // namespace penpose::app
