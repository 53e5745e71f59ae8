#pragma once

#include <span>
#include <vector>

#include "core/document/model.h"
#include "core/document/time/timeline.h"

namespace penpose::document {

/// Moments of an animation that lie nearer to each other than this are one.
inline constexpr double k_same_moment_s = 1e-4;

/// The moments at which any channel of weights or rotations has a key, ascending.
[[nodiscard]] std::vector<double> moments_of(const Animation& animation);

/// The poses that an animation goes through at the moments: weights within the parameters' ranges, and the rotations of
/// joints as turns from where they rest, within their limits. What has no parameter (translations, scales, joints that
/// are not posed) is left out.
[[nodiscard]] std::vector<PoseKey> poses_at(const Model& model, const Animation& animation,
                                            std::span<const double> times_s);

}  // namespace penpose::document
