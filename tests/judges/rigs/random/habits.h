#pragma once

#include "tests/judges/rigs/parts.h"
#include "tests/judges/rigs/random/dice.h"

namespace penpose::judges {

/// What else moves with a muscle whatever shape it is part of: a forehead with brows, lips with cheeks and a nose, a
/// chin with pressed lips. How much differs by maker; both sides are alike.
void add_habits(Parts& parts, const Dice& dice);

}  // namespace penpose::judges
