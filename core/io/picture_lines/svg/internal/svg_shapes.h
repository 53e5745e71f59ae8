#pragma once

#include <functional>
#include <string_view>

#include "core/base/result.h"
#include "core/io/picture_lines/svg/internal/outline_pen.h"
#include "core/io/picture_lines/svg/internal/svg_lengths.h"

namespace penpose::io {

/// The value of one of an element's attributes, empty where it has none.
using SvgAttributes = std::function<std::string_view(const char* name)>;

/// Whether elements of that name are drawn as lines (SVG 1.1, chapters 8 and 9).
[[nodiscard]] bool is_svg_shape(std::string_view tag);

/// Draws a shape. `viewport`: what its percentages are of. Errors: a value that is none; the place is in the value, or
/// empty.
[[nodiscard]] base::Status draw_shape(std::string_view tag, const SvgAttributes& attributes, Viewport viewport,
                                      OutlinePen& pen);

/// A length that an attribute gives, `otherwise` where it is absent or `auto`. Errors: no length.
[[nodiscard]] base::Result<double> svg_length(const SvgAttributes& attributes, const char* name, double whole,
                                              double otherwise);

}  // namespace penpose::io
