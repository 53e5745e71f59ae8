#pragma once

#include <array>

#include "core/mesh/triangle_mesh.h"

namespace penpose::tests {

/// A rectangle that faces the viewer, who looks down z.
inline void add_plate(mesh::MeshSource& source, double from_x, double to_x, double from_y, double to_y, double z) {
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  for (const auto& [x, y] : {std::array{from_x, from_y}, {to_x, from_y}, {to_x, to_y}, {from_x, to_y}})
    source.positions.emplace_back(x, y, z);
  source.triangles.push_back({first, first + 1, first + 2});
  source.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace penpose::tests
