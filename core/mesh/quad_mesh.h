#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::mesh {

using Quad = std::array<std::uint32_t, 4>;

/// A control cage or what became of it: quads, counter-clockwise from outside.
struct QuadMesh {
  std::vector<geometry::ModelPoint> positions;
  std::vector<Quad> quads;
  /// For every quad the number of the quad that it was cut from, in the mesh before the last level. Empty for a cage.
  std::vector<std::uint32_t> parents;
};

}  // namespace penpose::mesh
