#pragma once

#include <cstdint>
#include <span>

#include "core/base/result.h"
#include "core/io/picture_lines/picture_lines.h"

namespace penpose::io {

/// A picture: rows from the top, px from the left, 4 bytes R G B A each, sRGB.
struct PictureView {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> pixels;
};

/// The lines of a drawing on paper of any colour and uneven light, in px of the picture with (0, 0) at the corner of
/// its first px. What is transparent is white. Lines of different hue are different lines; at crossings and branches
/// the straightest goes on; gaps as wide as a line, or where a line of another hue lies across, are joined. Lines begin
/// at their left end. Errors: sizes of 0 or above 16384 or that do not fit the pixels; ink on more than half of the
/// picture, or more than 10000 lines, as of a photograph.
[[nodiscard]] base::Result<PictureLines> trace_lines(const PictureView& picture);

}  // namespace penpose::io
