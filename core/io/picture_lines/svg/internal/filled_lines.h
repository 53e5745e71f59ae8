#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/io/picture_lines/svg/internal/outline_pen.h"

namespace penpose::io {

/// A filled shape as its outlines; `even_odd`: which of SVG's two rules says what is inside.
struct FilledShape {
  std::span<const Contour> outlines;
  bool even_odd = false;

  /// Whether it looks like a line that a brush drew: all outlines closed, and at least eight times as long as wide.
  [[nodiscard]] bool is_line() const;
  /// How many px middle_lines looks at.
  [[nodiscard]] std::uint64_t px() const;
};

/// The lines in the middle of a shape that is_line: it is filled in a picture of such a scale that it is a few px wide,
/// and that is traced as other pictures are. Empty where that finds less than half of its length.
[[nodiscard]] std::vector<Contour> middle_lines(const FilledShape& shape);

}  // namespace penpose::io
