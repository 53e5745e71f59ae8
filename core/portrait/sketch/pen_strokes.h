#pragma once

#include <vector>

#include "core/geometry/space.h"

namespace penpose::portrait {

/// Returns the middle line of the outline of a pen stroke: of a closed line that is long and thin. Returns any other
/// line as it is.
[[nodiscard]] std::vector<geometry::PxPoint> middle_of_stroke(const std::vector<geometry::PxPoint>& line);

}  // namespace penpose::portrait
