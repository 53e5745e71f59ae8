#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "core/geometry/space.h"

namespace penpose::geometry {

/// The rotation by `angle` radians about a unit axis (Rodrigues), counter-clockwise when the axis points at the viewer.
[[nodiscard]] glm::dmat3 rotation_about(const ModelVector& unit_axis, double angle);

/// The turn that takes direction `from` to direction `to` by the shortest way: axis = cross product, angle between.
/// Opposite directions turn about an axis perpendicular to both, chosen the same way every time; a zero vector gives no
/// turn.
struct Turn {
  ModelVector axis{0, 0, 1};
  double angle = 0;  ///< radians, 0..pi
};
[[nodiscard]] Turn turn_between(const ModelVector& from, const ModelVector& to);

/// Rotations about the x, then the turned y, then the turned z axis (radians): Rx Ry Rz as matrices.
[[nodiscard]] glm::dquat quaternion_from_xyz(const glm::dvec3& angles);
/// The inverse of quaternion_from_xyz; y in -pi/2..pi/2.
[[nodiscard]] glm::dvec3 xyz_from_quaternion(const glm::dquat& rotation);

/// Translation * rotation * scale, as glTF composes a node's matrix. The quaternion is normalised first.
[[nodiscard]] glm::dmat4 compose(const glm::dvec3& translation, const glm::dquat& rotation, const glm::dvec3& scale);

}  // namespace penpose::geometry
