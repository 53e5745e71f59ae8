#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/result.h"
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

/// One level of Catmull and Clark's subdivision (1978): every quad becomes four, borders become cubic B-splines. Vertex
/// v of the mesh is vertex v of the result; where new vertices stand in the result follows from the quads alone, so
/// that two meshes with equal quads can be subdivided side by side. A new quad starts with the vertex in the middle of
/// its parent; the vertex opposite to it is the one it shares with the cage. Errors: an index out of range, or quads
/// that are no manifold (place "quad N").
[[nodiscard]] base::Result<QuadMesh> catmull_clark(const QuadMesh& mesh);

}  // namespace penpose::mesh
