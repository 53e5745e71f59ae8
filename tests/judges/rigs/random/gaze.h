#pragma once

#include "tests/judges/rigs/parts.h"
#include "tests/judges/rigs/random/dice.h"

namespace penpose::judges {

/// Makes look_ of a face that has balls anew: how far they turn and how much of it the lids go along with differs by
/// maker. Some leave the balls to joints, so that their shapes move lids only.
void add_gaze(Parts& parts, const Dice& dice);

/// Makes lips_close anew: the lower lip comes up and the upper one down by as much as the jaw parts them.
void add_lips_close(Parts& parts, const Dice& dice);

}  // namespace penpose::judges
