#pragma once

#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/rig/skeleton.h"

namespace penpose::joints {

using geometry::ModelPoint;
using geometry::ModelVector;

/// Where a joint stands in the world, and how it is turned there.
struct Place {
  ModelPoint at{0};
  glm::dquat turn{1, 0, 0, 0};
};

/// One a joint. `values` are those of Skeleton::parameters.
[[nodiscard]] std::vector<Place> places_of(const rig::Skeleton& skeleton, std::span<const double> values);

/// A joint that bends in one plane, as the slight bend of a limb's middle joint at rest shows.
struct Hinge {
  ModelVector axis{0, 0, 1};  ///< in the world at rest; turning about it bends the joint further
  double bent = 0;            ///< radians, > 0: how far it is bent at rest
};

/// What the shape of a skeleton tells about its joints, whatever they are called. Measured once for a rig.
class Body {
 public:
  explicit Body(const rig::Skeleton& skeleton);

  [[nodiscard]] std::size_t size() const { return parents_.size(); }
  [[nodiscard]] std::int32_t parent(std::size_t joint) const { return parents_[joint]; }
  [[nodiscard]] std::span<const Place> rest() const { return rest_; }
  /// Children that carry vertices or have a joint below that does; no helpers.
  [[nodiscard]] std::span<const std::size_t> branches(std::size_t joint) const { return branches_[joint]; }
  /// A joint without branches that lies on the bone of its parent and takes a share of its skin, as joints do that
  /// spread a twist: whoever draws along the bone means the parent.
  [[nodiscard]] bool helper(std::size_t joint) const { return helper_[joint]; }
  /// The joint itself, or the one that a helper helps.
  [[nodiscard]] std::size_t meant(std::size_t joint) const;
  /// Along the joint's bone, in the world at rest, length one: towards that of its branches which is in `chain`
  /// (ascending), else towards the middle of its branches, else away from its parent.
  [[nodiscard]] ModelVector bone(std::size_t joint, std::span<const std::size_t> chain) const;
  /// Of a limb's middle joint that is visibly bent at rest.
  [[nodiscard]] std::optional<Hinge> hinge(std::size_t joint) const;

 private:
  /// Whether the way without branches that a joint lies on is a limb: of a few joints, and longer than what hangs on
  /// its end. The spine, which carries the arms, is none.
  [[nodiscard]] bool on_limb(std::size_t joint) const;
  /// The longest way from a joint down.
  [[nodiscard]] double reach(std::size_t joint) const;

  std::vector<std::int32_t> parents_;
  std::vector<Place> rest_;
  std::vector<std::vector<std::size_t>> children_, branches_;
  std::vector<bool> helper_;
};

}  // namespace penpose::joints
