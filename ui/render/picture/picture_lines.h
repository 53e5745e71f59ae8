#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/io/picture_lines/picture_lines.h"

namespace penpose::render {

/// The lines of a drawing: those of an SVG as they are (io::read_svg_lines), those of a PNG, JPEG or WebP
/// traced (io::trace_lines). Which it is, its bytes say. Pictures of more than 4096 px a side are made smaller by whole
/// numbers first; the lines are in px of the file all the same. Errors: another format, and those of its reader.
[[nodiscard]] base::Result<io::PictureLines> read_picture_lines(base::Bytes bytes);

}  // namespace penpose::render
