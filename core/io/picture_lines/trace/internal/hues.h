#pragma once

#include <cstdint>
#include <span>

#include "core/io/picture_lines/trace/internal/bitmap.h"
#include "core/io/picture_lines/trace/internal/paper.h"

namespace penpose::io {

/// A px of a drawing that is no paper.
struct InkPixel {
  std::uint32_t index = 0;  ///< in a bitmap of the drawing's size
  PaperDifference difference;
};

/// Gives every px the number of its hue, from 1, and returns how many hues there are, 1 to 8. `strong`: from which size
/// on a difference has a hue that can be relied on.
int sort_by_hue(std::span<const InkPixel> pixels, int strong, Bitmap& hue);

}  // namespace penpose::io
