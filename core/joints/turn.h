#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/joints/body.h"

namespace penpose::joints {

/// A way in which a joint turns with less ease: the square of how far `along . w` lies outside low..high costs
/// `stiffness` (1 / radians squared).
struct Lean {
  glm::dvec3 along{0};
  double stiffness = 0;
  double low = 0, high = 0;  ///< radians, low <= 0 <= high

  /// How far outside, with its sign.
  [[nodiscard]] double beyond(const glm::dvec3& w) const;
};

/// How one joint turns from where it starts: by a rotation vector w along three axes of its own, two that bend its bone
/// and one that twists it.
///
///   rotation(w) = start * exp(axes * w)
struct Turn {
  std::size_t joint = 0;
  std::size_t first = 0;  ///< its first parameter of three
  glm::dquat start{1, 0, 0, 0};
  glm::dmat3 axes{1};   ///< columns: bend, bend, twist; length one, in the joint's own frame
  bool planar = false;  ///< the first axis is the view's direction, the second takes the bone out of the picture
  double across = 1;    ///< how much the bone lies across the view: 0 where a bend out of the picture shows at once
  bool bends_in_depth = false;  ///< it is a hinge, and so does it bend: about the second axis
  std::vector<Lean> leans;      ///< twist, limits about the rest pose, a hinge's plane and the way it bends
  glm::dvec3 minimum{0};        ///< of the parameters: hard limits
  glm::dvec3 maximum{0};

  /// What a rotation vector costs.
  [[nodiscard]] double cost(const glm::dvec3& w) const;
};

/// The joint's parameters (angles about x, y, z) at a rotation vector: of the ways to write the rotation the one that
/// the ranges change least, within the ranges.
[[nodiscard]] glm::dvec3 angles_of(const Turn& turn, const glm::dvec3& w);

/// `first`: the first of the joint's three parameters, `values` theirs at the start; `place` the joint's there.
/// `chain`: the joints that are drawn, ascending, which tell where a bone points. `view`: the direction in which the
/// one picture looks, or nothing where several views show the joint.
[[nodiscard]] Turn make_turn(const Body& body, const rig::Joint& joint, std::size_t number, std::size_t first,
                             std::span<const double> values, const Place& place, std::span<const std::size_t> chain,
                             const std::optional<ModelVector>& view);

/// Whether the joint has room about all its axes; those whose ranges leave it one or two turn by their angles alone.
[[nodiscard]] bool turns_freely(const rig::Joint& joint);

}  // namespace penpose::joints
