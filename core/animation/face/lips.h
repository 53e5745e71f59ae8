#pragma once

#include <span>

#include "core/animation/face/rest_choice.h"
#include "core/animation/head/head_motion.h"
#include "core/animation/points/curve_transfer.h"
#include "core/animation/track.h"

namespace penpose::animation {

/// Lips that touch appear to touch from every view, whatever depths are assumed for them. So the gap between the curves
/// is taken from the picture, turned back, and only the position of their middle from the head's shape.
void see_contacts(const PointTrack& track, std::span<const TrackedCurve> curves, StillTrack& still);

/// Lips are as far apart as they are seen, not as much farther than at rest: the gap that is left between them in the
/// chosen frame is added in all frames. The lower lip, which is farther from the middle of the stable points, moves
/// down by that.
void part_lips(std::span<const TrackedCurve> curves, const TrackFrame& neutral, const RestChoice& rest,
               StillTrack& still);

}  // namespace penpose::animation
