#pragma once

#include <array>
#include <span>

#include "core/intent/line/sliding.h"

namespace penpose::intent {

/// A part of a drawn line beyond an end of the curve that it was drawn for. An overshoot goes straight on; a part that
/// runs across the curve's direction is not an overshoot and tells where the end should be.
struct Overshoot {
  std::size_t end = 0;  ///< the reference point
  double share = 0;     ///< of the reference's length; 0: there is none
  PxPoint middle;       ///< of that part
  PxPoint across;       ///< the direction across the curve at its end, length one
  double spread = 0;    ///< variance of the part along `across`, px^2
};

/// The overshoots at the reference's first and last point, where they exceed what an unsteady hand draws. `seen`: the
/// reference's points in the picture, as matched. `doubt`: px.
[[nodiscard]] std::array<Overshoot, 2> overshoots(const SlidingLine& line, std::span<const PxPoint> seen,
                                                  const Alignment& alignment, const Matching& matching, double doubt);

}  // namespace penpose::intent
