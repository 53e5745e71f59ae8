#pragma once

#include <span>
#include <vector>

#include "core/document/model.h"
#include "core/document/time/timeline.h"

namespace penpose::document {

/// Times of an animation that are closer than this are one.
inline constexpr double k_same_moment_s = 1e-4;

/// The times at which any channel of weights or rotations has a key, ascending.
[[nodiscard]] std::vector<double> moments_of(const Animation& animation);

/// The poses of an animation at the times: weights within the parameters' ranges, and rotations of joints relative to
/// rest, within their limits. Channels without a parameter (translations, scales, joints that cannot be posed) are left
/// out.
[[nodiscard]] std::vector<PoseKey> poses_at(const Model& model, const Animation& animation,
                                            std::span<const double> times_s);

}  // namespace penpose::document
