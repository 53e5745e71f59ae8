#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::portrait {

/// The lines of a drawing after hatching was joined.
struct JoinedLines {
  std::vector<std::vector<geometry::PxPoint>> lines;
  std::vector<std::size_t> joined_in;  ///< one a line of the drawing: its number in `lines`
};

/// Joins short strokes beside each other, such as the hairs of a brow or the lashes of a lid, to one line through their
/// middles, and takes outlines of pen strokes as their middle lines. All other lines stay as they are. Precondition: no
/// line is empty.
[[nodiscard]] JoinedLines join_hatching(std::span<const std::vector<geometry::PxPoint>> drawn);

}  // namespace penpose::portrait
