#pragma once

#include <array>
#include <optional>

#include "core/portrait/surface/face_surface.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

/// The lids of one eye, from its outer to its inner corner.
struct Eye {
  ModelPoint centre{0};  ///< in the face's frame: the middle between its corners
  double width = 0;      ///< between its corners
  FoundLine upper, lower;
};

/// Returns how far the best control closes an eye: 0..1.
[[nodiscard]] double closing(const rig::Rig& rig, const intent::WholeModel& whole, const FaceSurface& surface,
                             const Eye& eye);

/// The right eye and the left one: where balls are seen through the skin, or else holes of the skin that mirror each
/// other. Nothing where there are none.
[[nodiscard]] std::optional<std::array<Eye, 2>> find_eyes(const rig::Rig& rig, const intent::WholeModel& whole,
                                                          const FaceSurface& surface);

}  // namespace penpose::portrait
