#pragma once

#include "ui/render/picture/image.h"

namespace penpose::render {

/// Draws a picture twice as wide and high into another, px between px mixed 3 to 1; what of it does not fit the other's
/// size is left out. Precondition: neither is empty, and the other is at most twice as large.
void draw_doubled(const Image& small, Image& picture);

}  // namespace penpose::render
