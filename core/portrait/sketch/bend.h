#pragma once

#include <vector>

#include "core/portrait/sketch/face_layout.h"

namespace penpose::portrait {

/// Lines of one part of a drawn face.
using Marks = std::vector<const FaceMark*>;

/// Holds the box of lines, in distances of the eyes.
struct Extent {
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  [[nodiscard]] double width() const { return high.x - low.x; }
  [[nodiscard]] double middle() const { return 0.5 * (low.x + high.x); }
};
/// Returns the box of all marks.
[[nodiscard]] Extent extent_of(const Marks& marks);

/// Coefficients of the parabola y = at + slope t + curve (t^2 - 1/3) that fits marks best, t from -1 to 1 over an
/// extent.
struct Bend {
  double at = 0, slope = 0, curve = 0;
};
/// Returns the parabola of least squares, weighted by length.
[[nodiscard]] Bend bend_of(const Marks& marks, const Extent& extent);

}  // namespace penpose::portrait
