#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::document {

/// The animation that goes through the poses at the times, linear between them: a weights channel for blend shapes and
/// deformers and a rotation channel for each joint that turns. Times start at 0 and, like values, are rounded to float,
/// as files keep them; a pose whose time is then not after the one before is left out. Precondition: one time a pose,
/// one value a parameter of the model.
[[nodiscard]] Animation make_animation(const Model& model, std::string name, std::span<const double> times_s,
                                       std::span<const rig::Pose> poses);

/// How the whole model stands at one time, in world space: p becomes pivot + shift + scale * rotation * (p - pivot).
struct Stand {
  glm::dquat rotation{1, 0, 0, 0};
  geometry::ModelVector shift{0};
  double scale = 1;
};
/// The model with the whole of it moved by the animation too: the joints without parents are moved, and vertices that
/// no joint carries, all of them where there is no skeleton, are given to one more joint "head" at the origin.
/// Precondition: one time a stand. Errors of the rig.
[[nodiscard]] base::Result<Model> with_stand(Model model, std::size_t animation, const geometry::ModelPoint& pivot,
                                             std::span<const double> times_s, std::span<const Stand> stands);

}  // namespace penpose::document
