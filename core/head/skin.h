#pragma once

#include <cstdint>
#include <vector>

#include "core/head/cage.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::head {

/// The finished half of the skin, in centimetres: vertices with x = 0 lie on the mirror plane.
struct Half {
  std::vector<ModelPoint> points;
  std::vector<LoopMark> marks;
  std::vector<mesh::Quad> quads;       ///< counter-clockwise from outside; corner 0 is the middle of a coarser quad
  std::vector<std::uint32_t> coarser;  ///< one a quad: the number of that coarser quad
  std::vector<QuadKind> kinds;         ///< one a quad
};

/// Cage, two levels of subdivision, sculpting, lids on the eyeball and lips that meet.
[[nodiscard]] base::Result<Half> make_half();

/// A surface of triangles, both halves, in centimetres.
struct Surface {
  std::vector<ModelPoint> points;
  std::vector<mesh::Triangle> triangles;
};
/// The skin in three materials that share their borders exactly.
struct Skin {
  Surface bare;
  Surface lips;
  Surface brows;
  Surface lining;  ///< of mouth and nostrils
  Surface lashes;  ///< the edges of the upper lids
};
/// Triangles of the half (coarse where that is enough) and their exact mirror images.
[[nodiscard]] Skin make_skin(const Half& half);

/// Adds the mirror image of a half surface; vertices with x = 0 are shared.
[[nodiscard]] Surface mirrored(const std::vector<ModelPoint>& points, const std::vector<mesh::Triangle>& triangles);

}  // namespace penpose::head
