#pragma once

#include <array>

#include "core/portrait/features/eyes.h"
#include "core/portrait/surface/surface_paint.h"

namespace penpose::portrait {

/// The brows over both eyes, the right one first, from the outer to the inner end: the middle of a piece or of a
/// material above the eye, or of a strip that is painted there (find_painted_brows), or of where controls of the brows
/// move the skin, or else of the ridge, which says little.
[[nodiscard]] std::array<FoundLine, 2> find_brows(const rig::Rig& rig, const intent::WholeModel& whole,
                                                  const FaceSurface& surface, const SurfacePaint& paint,
                                                  const std::array<Eye, 2>& eyes);

}  // namespace penpose::portrait
