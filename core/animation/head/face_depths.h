#pragma once

#include <span>

#include "core/animation/head/head_motion.h"

namespace penpose::animation {

/// Removes the error that the head's turns leave in the offsets because the face differs from the assumed depths: a
/// point that is deeper by d than assumed appears off by d times the sine of the turn, in every frame. d is found for
/// each point from the whole clip, by robust least squares (Huber 1964) with a prior of no difference (ridge), so that
/// a head that hardly turns changes nothing. `but`: points that do not change.
void learn_depths(StillTrack& track, std::span<const std::size_t> but, double extent_px);

}  // namespace penpose::animation
