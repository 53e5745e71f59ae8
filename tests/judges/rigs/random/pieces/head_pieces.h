#pragma once

#include "tests/judges/rigs/random/dice.h"
#include "tests/judges/rigs/random/pieces/pieces.h"

namespace penpose::judges {

/// Teeth and a tongue: the upper ones stay, the others go with the jaw.
void add_mouth_inside(Pieces& pieces, const Parts& parts, Dice dice);
/// A cap of hair and ears, most of which stay where they are.
void add_hair_and_ears(Pieces& pieces, const Parts& parts, Dice dice);
/// A neck and shoulders, which stay where they are.
void add_shoulders(Pieces& pieces, const Parts& parts, Dice dice);

}  // namespace penpose::judges
