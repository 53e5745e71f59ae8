#pragma once

#include "tests/judges/rigs/sets.h"
#include "tests/support/models/stick_figure.h"

namespace penpose::judges {

/// A skeleton as heads of avatars have: root, neck, head, jaw and a joint for each eye (if there are balls). Returns
/// the number of the head's.
std::size_t add_head_bones(FaceBuilder& face, const Parts& parts);

/// A figure of tubes as a rig. Joints are called j0, j1, ... as StickFigure numbers them.
[[nodiscard]] Rig limb_rig(std::string name, std::string kind, Group group, const tests::StickFigure& figure,
                           std::vector<Move> moves);

}  // namespace penpose::judges
