#pragma once

#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/articulation/region/region.h"

namespace penpose::articulation {

/// The border of a region as lines over the surface: half-way along the edges that lead out of it, joined and a little
/// smoothed. A closed line ends where it begins. For display.
[[nodiscard]] std::vector<std::vector<ModelPoint>> border_of(const Canvas& canvas, const Region& region);

}  // namespace penpose::articulation
