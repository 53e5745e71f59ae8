#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/io/project/case_file.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

/// A line drawn along a limb whose pose is known.
struct Limb {
  io::PoseCase asked;
  std::string hand;
  rig::Pose truth;
};

/// Each move of the rig, drawn on the side that is seen. Precondition: the rig has a skeleton.
[[nodiscard]] std::vector<Limb> limbs(const Rig& rig, Extent extent);

/// The pose in which joints are turned about axes of the world, one after the other, all else at rest. Joints that
/// cannot turn stay.
[[nodiscard]] rig::Pose turned_pose(const document::Model& model, std::span<const Move::Turn> turns);

/// The longest side of the box of the model at rest: the height of one that stands.
[[nodiscard]] double height_of(const document::Model& model);

}  // namespace penpose::judges
