#pragma once

#include <algorithm>
#include <array>

#include "core/portrait/surface/face_surface.h"
#include "core/portrait/surface/surface_paint.h"

namespace penpose::portrait {

/// Where the brow of one eye may be, px.
struct BrowWindow {
  double outer = 0, inner = 0;  ///< columns; the outer end first
  int bottom = 0, top = 0;      ///< rows
  double unit = 1;              ///< px of the distance of the eyes
  /// The i-th of a number of columns from the outer to the inner end.
  [[nodiscard]] double column(std::size_t i, std::size_t columns) const {
    return outer + (inner - outer) * static_cast<double>(i) / static_cast<double>(columns - 1);
  }
  [[nodiscard]] bool holds(double x, double y) const {
    return x >= std::min(outer, inner) && x <= std::max(outer, inner) && y >= bottom && y <= top;
  }
};

/// Finds brows that are painted on the skin, the right one first, from the outer to the inner end: in each window the
/// strip whose colour differs from that of the skin above and below it. A side without one has no points.
[[nodiscard]] std::array<FoundLine, 2> find_painted_brows(const FaceSurface& surface, const SurfacePaint& paint,
                                                          const std::array<BrowWindow, 2>& windows);

}  // namespace penpose::portrait
