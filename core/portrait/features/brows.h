#pragma once

#include <array>

#include "core/portrait/features/eyes.h"

namespace penpose::portrait {

/// The brows over both eyes, the right one first, from the outer to the inner end: the middle of a piece or of a
/// material above the eye, or of where controls of the brows move the skin, or else of the ridge, which says little.
[[nodiscard]] std::array<FoundLine, 2> find_brows(const rig::Rig& rig, const intent::WholeModel& whole,
                                                  const FaceSurface& surface, const std::array<Eye, 2>& eyes);

}  // namespace penpose::portrait
