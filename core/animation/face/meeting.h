#pragma once

#include <span>

#include "core/animation/points/curve_transfer.h"

namespace penpose::animation {

/// Lets curves that meet share what one of them cannot do. Trackers close an eye from both sides, a rig mostly with the
/// upper lid alone: where a curve cannot follow, the one that it meets goes so much farther that the opening between
/// them is as wide as the tracked one. How well a curve follows is how far the parameters in `free` can move it, in the
/// picture, against twice the mean of both (at most 1). Sets Transfer::meetings. Precondition: `curves` are those that
/// the transfer was made of, `neutral` its neutral frame.
void share_meetings(const rig::Rig& rig, std::span<const double> rest, std::span<const std::size_t> free,
                    const TrackFrame& neutral, std::span<const TrackedCurve> curves, const geometry::Camera& camera,
                    Transfer& transfer);

}  // namespace penpose::animation
