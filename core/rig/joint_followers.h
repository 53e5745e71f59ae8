#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/interface.h"
#include "core/rig/character_rig.h"

namespace penpose::rig {

/// Finds the vertices that follow a joint, and where they go when only that joint turns. A turn costs only what hangs
/// below the joint, and gives the same bits as CharacterRig::evaluate. The object holds scratch memory; the rig must
/// outlive it. Parameters have the skeleton's numbers.
class JointFollowers : public base::Fixed {
 public:
  /// Precondition: the rig has a skeleton.
  explicit JointFollowers(const CharacterRig& rig);

  /// Returns false if a parameter also drives a layer, which may move vertices that do not follow its joint.
  [[nodiscard]] bool are_all(std::size_t parameter) const { return !drives_[parameter]; }
  /// Returns the vertices that a joint or one below it influences, ascending. They stay valid until the next call.
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t joint);
  /// Writes where these vertices are if a parameter of that joint is at `value` and all others are at rest.
  /// Preconditions: the last call of `of` was for this joint, are_all(parameter), and `places` has one place a vertex.
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
