#pragma once

#include "core/portrait/features/eyes.h"
#include "core/portrait/features/mouth_seam.h"

namespace penpose::portrait {

/// The bridge from between the eyes to the tip, which is what protrudes most in the middle, and the base from right to
/// left: the hollow between the tip and the mouth.
struct Nose {
  FoundLine bridge, base;
};
[[nodiscard]] Nose find_nose(const FaceSurface& surface, const std::array<Eye, 2>& eyes, const MouthSeam& seam);

/// The edge of the face below and beside the mouth, from the right ear over the chin to the left one: where the surface
/// turns most. And the part of it that is the chin.
struct Jaw {
  FoundLine jaw, chin;
};
[[nodiscard]] Jaw find_jaw(const FaceSurface& surface, const std::array<Eye, 2>& eyes, const MouthSeam& seam);

}  // namespace penpose::portrait
