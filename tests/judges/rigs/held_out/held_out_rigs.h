#pragma once

#include "tests/judges/rigs/rig.h"

namespace penpose::judges {

/// Nobody chooses a constant, a rule or a fix by looking at what these rigs do, case by case.
[[nodiscard]] Rig make_facs();
[[nodiscard]] Rig make_creature();
[[nodiscard]] Rig make_doubles();
[[nodiscard]] Rig make_correctives();
[[nodiscard]] Rig make_face_bones();
[[nodiscard]] Rig make_expressions();
[[nodiscard]] Rig make_quadruped();

}  // namespace penpose::judges
