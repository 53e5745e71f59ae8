#pragma once

#include <vector>

#include "core/io/picture_lines/trace/internal/ink.h"
#include "core/io/picture_lines/trace/internal/skeleton.h"

namespace penpose::io {

/// A line as somebody drew it.
struct TracedStroke {
  std::vector<geometry::PxPoint> points;
  double radius = 0;  ///< half of its width (px)
  bool closed = false;
};

/// Makes strokes of the edges of a skeleton: where several meet, the two that go on straightest are one.
[[nodiscard]] std::vector<TracedStroke> strokes_of(const Skeleton& skeleton);

/// Joins strokes whose ends look at each other across a gap that is no wider than they are, or that other ink covers.
void join_gaps(std::vector<TracedStroke>& strokes, const Ink& ink);

/// Moves a stroke from the middles of px to the middle of its ink, and takes the steps of px out of it. `weights`: how
/// much ink of its hue a px has.
void refine(TracedStroke& stroke, const Bitmap& weights);

}  // namespace penpose::io
