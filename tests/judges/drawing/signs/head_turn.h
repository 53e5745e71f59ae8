#pragma once

#include <span>

#include "tests/judges/drawing/signs/face_signs.h"

namespace penpose::judges::drawn {

/// Curves with the turn and shift of the head taken out.
struct HeldStill {
  CurvePlaces places;
  double degrees = 0;  ///< by which the head was turned
};

/// The rigid motion is that of the points which expressions leave where they are (Horn, "Closed-form solution of
/// absolute orientation using unit quaternions", 1987). Fewer than three such points: nothing is taken out.
[[nodiscard]] HeldStill without_head_turn(const CurvePlaces& rest, const CurvePlaces& posed,
                                          std::span<const FaceSigns::Point> fixed);

}  // namespace penpose::judges::drawn
