#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::intent {

/// The effect of one control on a model, summed over its vertices.
struct ControlMoments {
  double way = 0;                      ///< sum of the displacements of all vertices, model units
  geometry::ModelPoint centre{0};      ///< where it moves the model: the mean place, weighted by displacement
  geometry::ModelVector direction{0};  ///< mean displacement, weighted by its length, over the mean length
  double radius = 0;                   ///< root mean square distance from the centre, with the same weights
};
[[nodiscard]] ControlMoments moments_of(std::span<const geometry::ModelPoint> rest,
                                        std::span<const geometry::ModelPoint> moved);

/// The control that does the same on the other side, for each control; static_cast<std::size_t>(-1) where there is
/// none. Real heads are not symmetric and may be turned a little: the search for the mirror plane starts near the
/// planes of the axes and is refined from the pairs themselves. Controls in the middle (both of jawLeft and jawRight)
/// have no partner.
[[nodiscard]] std::vector<std::size_t> mirror_pairs(std::span<const ControlMoments> controls,
                                                    const geometry::ModelPoint& middle, double size);

}  // namespace penpose::intent
