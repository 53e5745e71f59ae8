#pragma once

#include <functional>

#include "tests/judges/rigs/random/names.h"
#include "tests/judges/rigs/random/pieces/body.h"

namespace penpose::judges {

/// What joints carry; regions that they do not carry are left to shapes.
struct JointPlan {
  bool head = false;  ///< neck, head and eyes
  bool jaw = false;
  bool brows = false, lids = false, mouth = false;
  bool body = false;
  [[nodiscard]] bool any() const { return head; }
};

/// `dice` alone decide. One in some rigs has none, one in some a face of nothing but joints.
[[nodiscard]] JointPlan random_joint_plan(const Dice& dice);

/// The joints of a plan, which turn as the face's muscles move it, in frames of their own. `plain` is the face as it
/// was sculpted and `marks` its landmarks without a body; `placed` and `turn` take its places and its directions to
/// those of the model.
void add_random_joints(FaceBuilder& face, const Parts& plain, const Landmarks& marks, std::span<const BodyPiece> body,
                       const JointPlan& plan, Names& names, const Dice& dice,
                       const std::function<ModelPoint(const ModelPoint&)>& placed,
                       const std::function<ModelVector(const ModelVector&)>& turn);

}  // namespace penpose::judges
