#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::document {

/// The animation through the poses at the times, linear between them: a weights channel for blend shapes and
/// deformers and a rotation channel for each joint that turns. Times start at 0 and, like values, are rounded to float,
/// as in files; a pose whose rounded time is not after the one before is left out. Precondition: one time a pose,
/// one value a parameter of the model.
[[nodiscard]] Animation make_animation(const Model& model, std::string name, std::span<const double> times_s,
                                       std::span<const rig::Pose> poses);

/// Where the whole model is at one time, in world space: p becomes pivot + shift + scale * rotation * (p - pivot).
struct Placement {
  glm::dquat rotation{1, 0, 0, 0};
  geometry::ModelVector shift{0};
  double scale = 1;
};
/// Lets the animation also move the whole model: its joints without parents move, and vertices that follow no joint
/// (all of them in a model without a skeleton) follow one more joint, "head", at the origin. Precondition: one
/// placement a time. Errors of the rig.
[[nodiscard]] base::Result<Model> with_placements(Model model, std::size_t animation, const geometry::ModelPoint& pivot,
                                                  std::span<const double> times_s,
                                                  std::span<const Placement> placements);

}  // namespace penpose::document
