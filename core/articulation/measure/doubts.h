#pragma once

#include <string>
#include <vector>

#include "core/articulation/deformer.h"

namespace penpose::articulation {

/// An edge may be stretched by this times the ratio of the target's length to the reference's (at least 1) before the
/// user is warned.
inline constexpr double k_told_stretch = 2;
/// The user is warned of a target this many times as long as its reference.
inline constexpr double k_told_length = 2;

/// Warnings about a measured deformer, one line each: triangles that it turns over, a surface that it creases or
/// stretches, an inferred reference that cannot be trusted, a target much longer or shorter than its feature or drawn
/// against it, a second region that extends beyond the first. None for deformers of the paper, which are not measured.
[[nodiscard]] std::vector<std::string> doubts_of(const Deformer& deformer);

}  // namespace penpose::articulation
