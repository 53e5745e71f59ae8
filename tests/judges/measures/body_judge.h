#pragma once

#include "tests/judges/measures/whole_face.h"

namespace penpose::judges {

/// In per cent of the figure's height: error is the root mean square over all vertices, stray the largest movement
/// of a vertex that should move by less than 0.5 %.
void judge_body(const WholeFace& figure, const rig::Pose& truth, const rig::Pose& found, Outcome& outcome);

}  // namespace penpose::judges
