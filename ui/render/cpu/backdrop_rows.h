#pragma once

#include <cstdint>
#include <span>

#include "ui/render/behind.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Px of one row, 4 bytes R G B A each, from the column `left` on: the gradient of the background with a picture
/// that is behind the model over it (k_background_fragment in ui/render/gl/shaders.h, BehindPass).
void draw_backdrop_row(const Background& colors, const Behind& behind, geometry::Viewport size, int y, int left,
                       std::span<std::uint8_t> row);

/// The picture alone over what the px of a row are already.
void draw_behind_row(const Behind& behind, int y, int left, std::span<std::uint8_t> row);

}  // namespace penpose::render
