#pragma once

#include "tests/judges/rigs/builder.h"
#include "tests/judges/rigs/random/names.h"

namespace penpose::judges {

/// Adds the shapes of a random maker: single muscles of both sides or of each, sums, halves, mouths of speech, whole
/// faces, corrections and what is of no use, in sets of which a rig has one or many. Returns a word for what it is.
std::string add_random_shapes(FaceBuilder& face, const Parts& parts, Names& names, const Dice& dice);

/// How many corrections a rig with these dice has (random_parts.h).
[[nodiscard]] std::size_t corrections_of(const Dice& dice);

}  // namespace penpose::judges
