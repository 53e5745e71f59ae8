#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::portrait {

/// What part of a face a curve is.
enum class Part : unsigned char { brow, eye, nose, mouth, jaw, crown, other };

/// By its name, as maps and landmark files write it ("brow_L", "eyelid_upper_L", "lip_upper_outer").
[[nodiscard]] Part part_named(const std::string& name);

/// A way in which a drawing may be in other proportions than the model.
struct Proportion {
  /// The ways of all points of all curves for it doubled, px.
  std::vector<std::vector<geometry::PxPoint>> ways;
};

/// Returns the proportions in which drawings differ: how far apart the eyes are, how wide the mouth is, how high the
/// brows are above the eyes, how long the nose is, how long the face is below the eyes. `curves`: points in the
/// picture, px, y down. Parts that are missing have no proportion of their own.
[[nodiscard]] std::vector<Proportion> proportions_of(std::span<const std::vector<geometry::PxPoint>> curves,
                                                     std::span<const Part> parts);

}  // namespace penpose::portrait
