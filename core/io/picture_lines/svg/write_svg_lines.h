#pragma once

#include <string>

#include "core/io/picture_lines/picture_lines.h"

namespace penpose::io {

/// An SVG of black lines: a path a line, in the order of the lines, with the name as its id, as read_svg_lines takes
/// them; coordinates to 1/1000 px. Precondition: width and height are above 0, coordinates finite.
[[nodiscard]] std::string write_svg_lines(const PictureLines& drawing);

}  // namespace penpose::io
