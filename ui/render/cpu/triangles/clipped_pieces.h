#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/triangle_mesh.h"
#include "ui/render/cpu/triangles/triangle_raster.h"

namespace penpose::render {

/// What is seen of a triangle that reaches before the near plane or far beyond the picture.
struct Piece {
  std::uint32_t item = 0;  ///< of the triangle
  Corners corners;
  std::array<glm::vec3, 3> shares{};  ///< of the triangle's corners in each corner
};

/// Cuts a triangle at the near plane and at the borders of the picture; adds up to six pieces, which keep its
/// direction of turning.
void add_pieces(const Raster& raster, std::span<const glm::vec3> positions, const mesh::Triangle& triangle,
                std::uint32_t item, std::vector<Piece>& pieces);

}  // namespace penpose::render
