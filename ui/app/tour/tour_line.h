#pragma once

#include <span>
#include <string>

#include "core/geometry/space.h"

namespace penpose::app {

using geometry::PxPoint;

/// How a line that was drawn compares with the one that was asked for, in the same picture.
struct LineJudgement {
  bool near = false;
  std::string again;  ///< what to try again, where it is not
};

/// A line that a tour asks for.
struct AskedLine {
  std::span<const PxPoint> line;
  std::span<const PxPoint> from;  ///< where the feature is that it moves: to draw there is no answer. May be empty
  double within_px = 20;          ///< what a line may stray by in the mean
  bool closed = false;
};

/// Near enough is a line whose mean distance from the one that was asked for is within its bounds, and the other way
/// round, so that neither a part of it nor more than it will do; and that is nearer to it than to `from`. In which
/// direction it was drawn says nothing.
[[nodiscard]] LineJudgement judge_line(std::span<const PxPoint> drawn, const AskedLine& asked);

/// Mean distance of evenly spaced points of one line from the nearest place on another, px.
[[nodiscard]] double mean_distance(std::span<const PxPoint> from, std::span<const PxPoint> to);

}  // namespace penpose::app
