#pragma once

#include "core/io/picture_lines/trace/internal/bitmap.h"
#include "core/io/picture_lines/trace/trace_lines.h"

namespace penpose::io {

/// What was drawn on the paper of a picture.
struct Ink {
  Bitmap strength;          ///< how far a px is from its paper, 0..255
  Bitmap hue;               ///< 0: paper; 1..hues: which hue the ink has
  int hues = 0;             ///< 0 where there is no ink
  int threshold = 0;        ///< what is weaker is paper
  std::size_t covered = 0;  ///< px with ink
};

/// How much ink of a hue each px has, with the soft edges that are too weak to be ink themselves; less what may be
/// noise.
[[nodiscard]] Bitmap weights_of(const Ink& ink, int hue);

/// Tells ink from paper. The paper is what most of the px around have, in each channel (Gatos, Pratikakis and
/// Perantonis 2006, "Adaptive degraded document image binarization", estimate it as a surface, too), so that its light
/// may be uneven and it may be darker or lighter than the ink. Ink is what differs from it by more than the paper's
/// noise and a quarter of the mean ink. Its hue is the direction from paper to ink, which is the same for the faint
/// edge of a line and its middle; black and grey on white are one hue.
[[nodiscard]] Ink find_ink(const PictureView& picture);

}  // namespace penpose::io
