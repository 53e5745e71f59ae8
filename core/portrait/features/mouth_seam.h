#pragma once

#include <optional>
#include <vector>

#include "core/portrait/surface/face_surface.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

/// Where upper and lower lip meet or leave a gap, a column of the picture each.
struct MouthSeam {
  struct Column {
    int x = 0, upper = 0, lower = 0;  ///< the px of the lips at the seam; upper > lower
  };
  std::vector<Column> columns;  ///< from the right corner to the left one
  double parting = 0;           ///< how far a control opens it, as a share of the width; 0: no control does
  double sureness = 0;
};

/// Finds the line in the middle of the face above and below which surfaces are not next to each other, and which
/// controls part. Nothing where no line is like a mouth. `below`: it lies below this height (the eyes).
[[nodiscard]] std::optional<MouthSeam> find_mouth_seam(const rig::Rig& rig, const intent::WholeModel& whole,
                                                       const FaceSurface& surface, double below);

/// The seam's lines: the upper lip's and the lower lip's, from the right to the left corner.
[[nodiscard]] std::array<FoundLine, 2> inner_lips(const FaceSurface& surface, const MouthSeam& seam);

}  // namespace penpose::portrait
