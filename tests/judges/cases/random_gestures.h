#pragma once

#include "tests/judges/cases/gestures.h"

namespace penpose::judges {

/// Gestures of random kinds and sizes by random hands, of those that the rig has controls for: `count` of them, or
/// fewer where it has next to none. The same rig, seed and count give the same bits. Precondition: the rig has lines.
[[nodiscard]] std::vector<Gesture> random_gestures(const Rig& rig, std::uint64_t seed, std::size_t count);

}  // namespace penpose::judges
