#pragma once

#include "tests/judges/rigs/random/dice.h"
#include "tests/judges/rigs/random/pieces/pieces.h"

namespace penpose::judges {

/// Lashes on lids, whose tips turn with them and so go farther than they do.
void add_lashes(Pieces& pieces, const Parts& parts, Dice dice);
/// A shell over each ball, or a line of tears along its lower rim, between lids that it goes along with.
void add_eye_shells(Pieces& pieces, const Parts& parts, Dice dice);
/// Hair of brows: a strip over each, a little before the skin.
void add_brow_hair(Pieces& pieces, const Parts& parts, Dice dice);
/// Balls for eyes of a face that has none. They are parts.eyes from then on.
void add_balls(Parts& parts, Dice dice);

}  // namespace penpose::judges
