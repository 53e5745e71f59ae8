#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/io/picture_lines/picture_lines.h"

namespace penpose::io {

/// Whether bytes look like an SVG: XML whose first element is `svg`.
[[nodiscard]] bool looks_like_svg(base::Bytes bytes);

/// The lines of an SVG (1.1, second edition): path, line, polyline, polygon, rect, circle and ellipse, wherever groups,
/// nested svg and `use` put them, in units of the outermost viewBox from its corner; without one in px of the size that
/// the file gives, or as far as the lines reach. Curves become polylines to 1/10000 of the longer side. What is hidden,
/// has neither fill nor stroke, or is only kept for others (defs, symbol, clipPath, ...) gives none, and neither do
/// texts and pictures. An element that is filled, has no stroke and reaches over the whole drawing is its paper. One
/// that is filled alone and at least eight times as long as wide is a line of a brush: it becomes the line in its
/// middle. Errors: place is "line N"; no SVG, damaged data, coordinates beyond a million, or more than 32 MB, 100000
/// shapes, a million points or 100 elements inside each other.
[[nodiscard]] base::Result<PictureLines> read_svg_lines(base::Bytes bytes);

}  // namespace penpose::io
