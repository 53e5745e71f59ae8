#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::portrait {

/// What is read as one line of a face.
struct Stroke {
  std::vector<geometry::PxPoint> points;  ///< px of the sheet
  std::vector<std::size_t> lines;         ///< of the drawing, that it is part of
  bool lower = false;                     ///< the lower half of a line that is drawn around something
};

/// The strokes of a drawing. A line that is drawn around something, so that its ends meet, is two: an eye has two lids,
/// a mouth two lips, a face a chin and a crown. It is cut where it is farthest to either side. `given`: what was said
/// of each line, if anything; such a line is one.
[[nodiscard]] std::vector<Stroke> strokes_of(std::span<const std::vector<geometry::PxPoint>> lines,
                                             std::span<const std::optional<std::size_t>> given);

}  // namespace penpose::portrait
