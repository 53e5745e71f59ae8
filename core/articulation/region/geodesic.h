#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/articulation/region/patch.h"

namespace penpose::articulation {

/// A node with a given distance.
struct GeodesicSeed {
  std::uint32_t node = 0;
  double distance = 0;
};

/// The distance of every node of a patch from the seeds over the surface, by fast marching (Kimmel and Sethian 1998):
/// across each triangle, the distance from the virtual source that fits both known corners. Only open nodes are
/// entered; the others, and those that cannot be reached, are infinitely far.
[[nodiscard]] std::vector<double> geodesic_distances(const Patch& patch, std::span<const GeodesicSeed> seeds,
                                                     std::span<const std::uint8_t> open);

}  // namespace penpose::articulation
