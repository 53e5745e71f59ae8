#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/document/time/animation_building.h"
#include "core/document/time/animation_sampling.h"

namespace penpose::document {

/// The joints that turn the head of a whole figure.
struct HeadJoints {
  std::uint32_t head = 0;            ///< no root
  std::vector<std::uint32_t> necks;  ///< its ancestors that are the neck, from the body to the head; may be empty
};

/// The head by the names that rigs have for it (Head, mixamorig:Head, J_Bip_C_Head, Bip01 Head, 頭, ...), if it carries
/// half of what the blend shapes move or there are none; else the joint that is farthest from the root and carries
/// nine tenths of that, where it carries no more than nine tenths of the model. None: there is no such joint below a
/// root, the model is a head alone.
[[nodiscard]] std::optional<HeadJoints> head_joints(const Model& model);

/// Lets the animation turn the head: its joint comes to stand as the placements' rotations say, about the model's axes
/// from rest, and the necks take half of that in equal parts. Shifts and scales are left out: a head stays on its neck.
/// Other turns of these joints in the animation are replaced. Precondition: one placement a time, joints of the model.
[[nodiscard]] Model with_head_turns(Model model, std::size_t animation, const HeadJoints& joints,
                                    std::span<const double> times_s, std::span<const Placement> placements);

/// How a joint has turned from rest, about the model's axes, where the joints stand so. Precondition: one a joint.
[[nodiscard]] glm::dquat turn_from_rest(const Model& model, std::uint32_t joint,
                                        std::span<const JointTransform> joints);

}  // namespace penpose::document
