#pragma once

#include <array>

#include "core/portrait/features/mouth_seam.h"

namespace penpose::portrait {

/// The borders of the red of upper and lower lip, from the right to the left corner: where a material ends, or else
/// where the surface turns most between a bulge, the lip, and a hollow around it, at about the height of a lip.
[[nodiscard]] std::array<FoundLine, 2> lip_borders(const FaceSurface& surface, const MouthSeam& seam);

}  // namespace penpose::portrait
