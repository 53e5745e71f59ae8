#pragma once

#include "tests/judges/rigs/builder.h"
#include "tests/judges/rigs/expressions.h"
#include "tests/judges/rigs/random/dice.h"

namespace penpose::judges {

/// Whole faces with their names: joy, angry, sorrow, fun, surprised (`standard`: all of them) and others. Some blink,
/// raise brows or open the mouth, some do not.
[[nodiscard]] std::vector<std::pair<std::string, Recipe>> random_faces(const Dice& dice, bool standard);

/// half_lids, half_lid_R, lower_teeth, kiss, joy, scowl, startled. Where eyes look is left out: lids alone do not say
/// it.
[[nodiscard]] std::vector<Expression> more_expressions();

/// Adds so many known poses of one to four controls at random values.
void add_random_poses(FaceBuilder& face, Dice dice, std::size_t count);

}  // namespace penpose::judges
