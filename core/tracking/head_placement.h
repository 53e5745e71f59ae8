#pragma once

#include <vector>

#include "core/animation/animate_track.h"
#include "core/document/time/animation_building.h"

namespace penpose::tracking {

/// Where on the model the head turns: the middle of the driven curves at rest.
[[nodiscard]] geometry::ModelPoint head_pivot(const rig::Rig& rig, const animation::TrackSetup& setup,
                                              const animation::TrackedAnimation& tracked,
                                              const geometry::Camera& camera);

/// The head's turns in model space, seen through the camera: px of the track become model units by the size that the
/// tracked curves have on the model. `smooth_s`: as animation::smooth_over_time.
[[nodiscard]] std::vector<document::Placement> head_placements(const animation::TrackedAnimation& tracked,
                                                               const geometry::ModelPoint& pivot,
                                                               const geometry::Camera& camera, double smooth_s);

}  // namespace penpose::tracking
