#pragma once

#include <span>

#include "core/animation/head/head_motion.h"

namespace penpose::animation {

/// Takes out what the head's turns leave in the offsets because the face is not the one whose depths were taken for it:
/// a point that lies deeper by d than was thought is seen off by d times the sine of the turn, in every frame. d is
/// found for each point from the whole clip, by robust least squares (Huber 1964) with a prior of no difference
/// (ridge), so that a head that hardly turns changes nothing. `but`: points that are left as they are.
void learn_depths(StillTrack& track, std::span<const std::size_t> but, double extent_px);

}  // namespace penpose::animation
