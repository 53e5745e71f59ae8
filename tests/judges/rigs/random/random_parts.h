#pragma once

#include "tests/judges/rigs/parts.h"
#include "tests/judges/rigs/random/dice.h"

namespace penpose::judges {

/// A head or a creature of random proportions, dense or coarse, sculpted by a random hand: what its muscles do differs
/// by maker. Beyond the muscles of parts.h it has
///   halves    upper_in_up_, upper_out_up_, lower_in_down_, lower_out_down_, smile_top_, smile_bottom_, lid_in_,
///             lid_out_, brow_mid_up_
///   nonsense  nothing, all, hair, ears, teeth, tongue: of those that the face has
[[nodiscard]] Parts random_parts(const Dice& dice);

/// Small corrections as files have them, which nobody draws: "fix_0", "fix_1", ...
void add_corrections(Parts& parts, std::size_t count, Dice dice);

}  // namespace penpose::judges
