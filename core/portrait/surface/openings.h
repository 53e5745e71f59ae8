#pragma once

#include <vector>

#include "core/portrait/surface/face_surface.h"

namespace penpose::portrait {

/// A hole in what is seen of the skin from the front, and its rim on the skin.
struct Opening {
  ModelPoint centre{0};              ///< in the frame; its z is 0
  double area = 0;                   ///< px
  std::vector<mesh::MeshPoint> rim;  ///< counter-clockwise as seen, from the left
  double enclosed = 0;               ///< share of the directions in which skin is next to the hole
};

/// Marks of a picture's px, by rows.
using Mask = std::vector<bool>;

/// Connected parts of a mask that do not touch the border of the picture, the largest first; those below `fewest` px
/// are left out.
[[nodiscard]] std::vector<Opening> openings_of(const FaceSurface& surface, const Mask& mask, double fewest);

}  // namespace penpose::portrait
