#pragma once

#include "tests/judges/rigs/rig.h"

namespace penpose::judges {

/// A face rig as some maker could have made it, called random_SEED: a face of its own proportions, shapes or joints or
/// both, and poses. The same bits on every machine. Making one takes a fraction of a second.
[[nodiscard]] Rig random_rig(std::uint64_t seed);

}  // namespace penpose::judges
