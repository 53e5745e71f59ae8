#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <span>

#include "core/joints/body.h"

namespace penpose::joints {

/// How one joint turns from where it starts: by a rotation vector w along three axes of its own, two that bend its bone
/// and one that twists it, so that twists can cost what bends do not. The first axis is the hinge where there is one.
///
///   rotation(w) = start * exp(axes * w)
struct Turn {
  std::size_t joint = 0;
  std::size_t first = 0;  ///< its first parameter of three
  glm::dquat start{1, 0, 0, 0};
  glm::dmat3 axes{1};       ///< columns: bend, bend, twist; in the joint's own frame
  glm::dvec3 low{0};        ///< soft limits of w, radians: <= 0
  glm::dvec3 high{0};       ///< >= 0
  glm::dvec3 stiffness{0};  ///< what the square of w costs, 1 / radians squared
  glm::dvec3 minimum{0};    ///< of the parameters: hard limits
  glm::dvec3 maximum{0};
};

/// Beyond a soft limit, the square of the way costs this, 1 / radians squared.
inline constexpr double k_limit = 50.0;

/// The joint's parameters (angles about x, y, z) at a rotation vector: of the ways to write the rotation the one that
/// the ranges change least, within the ranges.
[[nodiscard]] glm::dvec3 angles_of(const Turn& turn, const glm::dvec3& w);

/// `chain`: the joints that are drawn, ascending; they tell which way a bone points. `values` of the joint's three
/// parameters at the start, of which `first` is the first.
[[nodiscard]] Turn make_turn(const Body& body, const rig::Joint& joint, std::size_t number, std::size_t first,
                             std::span<const double> values, std::span<const std::size_t> chain);

/// Whether the joint turns freely: a file that gives it ranges of its own says more than its shape does.
[[nodiscard]] bool has_usual_ranges(const rig::Joint& joint);

}  // namespace penpose::joints
