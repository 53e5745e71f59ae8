#pragma once

#include <span>

#include "tests/judges/drawing/faces/shared_drawings.h"
#include "tests/judges/rigs/rig.h"

namespace penpose::judges::drawn {

/// The drawings below sets/seen or sets/held_out, in the order of their names; sets/README.md says whose they are.
/// Precondition: seen or held_out.
[[nodiscard]] std::span<const SharedDrawing> drawing_set(Group group);
/// The same hand's drawing of the face at rest; nullptr: there is none.
[[nodiscard]] const SharedDrawing* rest_by_the_same_hand(std::span<const SharedDrawing> set, const SharedDrawing& one);

}  // namespace penpose::judges::drawn
