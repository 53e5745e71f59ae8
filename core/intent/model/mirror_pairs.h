#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::intent {

/// What one control does to a model, summed up over its vertices.
struct ControlMoments {
  double way = 0;                      ///< sum of the ways of all vertices, model units
  geometry::ModelPoint centre{0};      ///< where it moves the model: the mean place, weighted by the way
  geometry::ModelVector direction{0};  ///< the mean of the movement, weighted by the way, over the mean way
  double radius = 0;                   ///< root mean square distance from the centre, weighted likewise
};
[[nodiscard]] ControlMoments moments_of(std::span<const geometry::ModelPoint> rest,
                                        std::span<const geometry::ModelPoint> moved);

/// The control that does the same on the other side, for each control; static_cast<std::size_t>(-1) where there is
/// none. Real heads are not symmetric and may be turned a little: the mirror plane is looked for near the planes of the
/// axes and found again from the pairs themselves. Controls in the middle (both of jawLeft and jawRight) have no
/// partner.
[[nodiscard]] std::vector<std::size_t> mirror_pairs(std::span<const ControlMoments> controls,
                                                    const geometry::ModelPoint& middle, double size);

}  // namespace penpose::intent
