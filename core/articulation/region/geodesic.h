#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/articulation/region/patch.h"

namespace penpose::articulation {

/// A node whose distance is known from the beginning.
struct GeodesicSeed {
  std::uint32_t node = 0;
  double distance = 0;
};

/// The distance of every node of a patch from the seeds over the surface, by a front that marches over the triangles
/// (Kimmel and Sethian 1998): across each triangle the distance from the point that both known corners see. Only nodes
/// that are open are entered; the others, and those that cannot be reached, are infinitely far.
[[nodiscard]] std::vector<double> geodesic_distances(const Patch& patch, std::span<const GeodesicSeed> seeds,
                                                     std::span<const std::uint8_t> open);

}  // namespace penpose::articulation
