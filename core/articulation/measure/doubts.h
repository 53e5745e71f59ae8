#pragma once

#include <string>
#include <vector>

#include "core/articulation/deformer.h"

namespace penpose::articulation {

/// An edge may be stretched by this times the ratio of the target's length to the reference's (at least 1) before a
/// user is told.
inline constexpr double k_told_stretch = 2;
/// A target this many times as long as its reference is told of.
inline constexpr double k_told_length = 2;

/// What a measured deformer does that its user may not have meant, one line each: triangles that it turns over, a
/// surface that it creases or stretches, an inferred reference that is not to be trusted, a target much longer or
/// shorter than its feature or drawn against it, a second region that reaches beyond the first. None for deformers of
/// the paper, of which this is not known.
[[nodiscard]] std::vector<std::string> doubts_of(const Deformer& deformer);

}  // namespace penpose::articulation
