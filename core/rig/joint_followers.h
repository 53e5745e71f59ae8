#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/interface.h"
#include "core/rig/character_rig.h"

namespace penpose::rig {

/// The vertices that follow each joint, and where they go when it alone turns from rest: a turn costs what hangs below
/// the joint, not the whole model. The same bits as CharacterRig::evaluate. Holds scratch memory; the rig must outlive
/// it. Parameters are numbered as in the skeleton.
class JointFollowers : public base::Fixed {
 public:
  /// Precondition: the rig has a skeleton.
  explicit JointFollowers(const CharacterRig& rig);

  /// False when a parameter also drives a layer, which may move vertices that do not follow its joint.
  [[nodiscard]] bool are_all(std::size_t parameter) const { return !drives_[parameter]; }
  /// The vertices in which a joint or one below it has a share, ascending. They stay until the next call.
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t joint);
  /// Their places with a parameter of that joint at `value` and all others at rest. Preconditions: `of` was asked for
  /// the joint last, are_all(parameter), and there is one place a vertex.
  void turn(std::size_t parameter, double value, std::span<ModelPoint> places);

 private:
  void order_joints();
  void list_influenced();
  void find_drivers();

  const CharacterRig& rig_;
  const Skeleton& skeleton_;
  std::vector<bool> drives_;             ///< one a parameter
  std::vector<double> values_;           ///< of the skeleton, at rest
  std::vector<ModelPoint> displaced_;    ///< at rest, before the skeleton carries them
  std::vector<std::uint32_t> order_;     ///< joints with vertices, each followed by what hangs below it
  std::vector<std::uint32_t> position_;  ///< in the order, one a joint
  std::vector<std::uint32_t> below_;     ///< how many of the order hang below a joint, with itself; 0: it carries none
  std::vector<std::uint32_t> first_influenced_, influenced_;  ///< vertices by the order, those of one joint ascending
  PosedJoints posed_;
  std::span<const std::uint32_t> turned_;  ///< of the order: what is not at rest
  std::span<const std::uint32_t> asked_;   ///< of the order: the joint last asked for and what hangs below it
  std::vector<std::uint64_t> marked_;      ///< one bit a vertex, none set between calls
  std::vector<std::uint32_t> vertices_;    ///< of the joint last asked for
};

}  // namespace penpose::rig
