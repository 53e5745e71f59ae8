#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/tracks/motion_track.h"

namespace penpose::tracking {

struct MotionAnimation {
  document::Animation animation;       ///< with the keys of the motion
  std::vector<double> times_s;         ///< of all keys, ascending
  std::vector<std::string> unmatched;  ///< expressions that the model has neither as such nor as a control
  std::vector<std::string> notes;
};

/// A motion on a model. A joint with rotations L at rest and W at rest in the world turns to L inverse(W) N W, N being
/// the bone's normalised rotation (VRMC_vrm_animation, "How to transform human pose"), turned about +y to where the
/// model looks. Bones that the model lacks turn those below them ("When the target model has few bones"). The hips move
/// with the ratio of both heights of hips at rest ("About translation scaling"). Expressions move their targets, by the
/// sum of their weights; eyes follow the gaze by their joints. Bones are told by
/// document::humanoid_of. Errors: nothing of the motion moves anything in the model.
[[nodiscard]] base::Result<MotionAnimation> animate_motion(const document::Model& model, const io::MotionTrack& motion);

}  // namespace penpose::tracking
