#pragma once

#include <span>
#include <vector>

#include "core/animation/track.h"

namespace penpose::io {

inline constexpr std::size_t k_ibug_points = 68;
inline constexpr std::size_t k_mediapipe_points = 468;
inline constexpr std::size_t k_mediapipe_iris_points = 478;

/// How far the 68 points of the Multi-PIE markup lie in front of the outer corners of the eyes on a common face, px at
/// the size of this one. A head that nods moves the tip of the nose more than the eyes; what is needed to tell so from
/// a pulled face is no more than this. Precondition: 68 points. Empty when the eyes have no distance.
[[nodiscard]] std::vector<double> common_depths(std::span<const animation::PxPoint> points);

}  // namespace penpose::io
