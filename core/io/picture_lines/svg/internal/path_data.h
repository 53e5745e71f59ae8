#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/io/picture_lines/svg/internal/outline_pen.h"

namespace penpose::io {

/// Draws path data (SVG 1.1, section 8.3). Errors: place is "character N" of the data, from 1.
[[nodiscard]] base::Status draw_path(std::string_view data, OutlinePen& pen);

}  // namespace penpose::io
