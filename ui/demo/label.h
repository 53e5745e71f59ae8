#pragma once

#include <string_view>

#include "ui/render/picture/color.h"
#include "ui/render/picture/image.h"

namespace penpose::demo {

/// Height and advance of a letter at scale 1.
inline constexpr int k_letter_height_px = 7;
inline constexpr int k_letter_advance_px = 6;

/// Writes a name into a picture in capitals of 5 x 7 dots, each `scale` px wide, on a soft dark shadow; '_' is a space,
/// and so is whatever is neither a letter nor a digit. `x`, `y`: the upper left corner; what lies outside is cut off.
void draw_label(render::Image& image, int x, int y, int scale, std::string_view text, const render::Color& color);

}  // namespace penpose::demo
