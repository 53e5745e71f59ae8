#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/portrait/surface/face_surface.h"

namespace penpose::portrait {

/// A component of the mesh beside the skin, with all that lies within its box.
struct Piece {
  geometry::Box box;  ///< in the face's frame
  std::size_t vertices = 0;
  std::vector<std::uint32_t> components;
};

/// A piece and its mirror image: the one on the right side first.
using PiecePair = std::array<Piece, 2>;

/// Pairs of pieces that mirror each other, in the picture of the face; the largest first.
[[nodiscard]] std::vector<PiecePair> find_piece_pairs(const FaceSurface& surface);

}  // namespace penpose::portrait
