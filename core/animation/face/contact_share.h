#pragma once

#include <span>

#include "core/animation/points/curve_transfer.h"

namespace penpose::animation {

/// Shares a movement between curves that meet. In a track both lids close an eye; in most rigs only the upper one
/// does. Where a curve cannot follow, the one that it meets moves farther, so that the opening between them is as wide
/// as in the track. How well a curve follows is how far the parameters in `free` can move it in the picture, relative
/// to twice the mean of both (at most 1). Sets Transfer::contact_shares. Precondition: the transfer was made from
/// `curves` and the neutral frame `neutral`.
void share_contact(const rig::Rig& rig, std::span<const double> rest, std::span<const std::size_t> free,
                   const TrackFrame& neutral, std::span<const TrackedCurve> curves, const geometry::Camera& camera,
                   Transfer& transfer);

}  // namespace penpose::animation
