#pragma once

#include <array>
#include <span>

#include "core/intent/line/sliding.h"

namespace penpose::intent {

/// A part of a drawn line beyond an end of the curve that it was drawn for. Who overshoots goes straight on: what lies
/// across the curve's own direction there is no overshoot but tells where the end should be.
struct Overshoot {
  std::size_t end = 0;  ///< the reference point
  double share = 0;     ///< of the reference's length; 0: there is none
  PxPoint middle;       ///< of that part
  PxPoint across;       ///< the direction across the curve at its end, length one
  double spread = 0;    ///< variance of the part along `across`, px^2
};

/// At the reference's first and last point, where it is told by more than the hand's own straying. `seen`: its points
/// on the picture, as they were matched. `doubt`: px.
[[nodiscard]] std::array<Overshoot, 2> overshoots(const SlidingLine& line, std::span<const PxPoint> seen,
                                                  const Alignment& alignment, const Matching& matching, double doubt);

}  // namespace penpose::intent
