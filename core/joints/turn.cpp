#include "core/joints/turn.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/math.h"
#include "core/geometry/rotation.h"

namespace penpose::joints {
namespace {

// Widths of what is usual, radians: 1 / width squared is what the square of a turn costs.
constexpr double k_bend = 4.5;         ///< next to nothing: only what is not drawn stays
constexpr double k_twist = 0.12;       ///< about the bone's own axis: no stroke along it shows that
constexpr double k_off_hinge = 0.7;    ///< across a hinge
constexpr double k_swing_limit = 1.4;  ///< from the rest pose: bends that are usual at all
constexpr double k_twist_limit = 0.5;
constexpr double k_straight = 0.1;  ///< a hinge gives by this beyond the straight limb

double cost_of(double width) { return 1.0 / (width * width); }

glm::dquat exp_of(const glm::dvec3& w) {
  const double angle = std::sqrt(glm::dot(w, w));
  if (!(angle > 1e-12)) return {1, 0.5 * w.x, 0.5 * w.y, 0.5 * w.z};
  const glm::dvec3 v = w * (base::sin(0.5 * angle) / angle);
  return {base::cos(0.5 * angle), v.x, v.y, v.z};
}

/// The rotation vector of a turn of at most half a circle.
glm::dvec3 log_of(const glm::dquat& q) {
  const glm::dvec3 v{q.x, q.y, q.z};
  const double sine = std::sqrt(glm::dot(v, v));
  if (!(sine > 1e-12)) return v * 2.0;
  return v * (2.0 * base::atan2(q.w < 0 ? -sine : sine, std::abs(q.w)) / sine);
}

/// Into -pi..pi.
double wrapped(double angle) {
  if (angle > base::k_pi) return angle - 2.0 * base::k_pi;
  if (angle < -base::k_pi) return angle + 2.0 * base::k_pi;
  return angle;
}

glm::dvec3 across(const glm::dvec3& unit) {
  const glm::dvec3 least = std::abs(unit.x) <= std::abs(unit.y) && std::abs(unit.x) <= std::abs(unit.z)
                               ? glm::dvec3{1, 0, 0}
                           : std::abs(unit.y) <= std::abs(unit.z) ? glm::dvec3{0, 1, 0}
                                                                  : glm::dvec3{0, 0, 1};
  return geometry::normalized(glm::cross(unit, least));
}

}  // namespace

glm::dvec3 angles_of(const Turn& turn, const glm::dvec3& w) {
  const glm::dquat q = turn.start * exp_of(turn.axes * w);
  const glm::dvec3 one = geometry::xyz_from_quaternion(q);
  const glm::dvec3 other{wrapped(one.x + base::k_pi), wrapped(base::k_pi - one.y), wrapped(one.z + base::k_pi)};
  const glm::dvec3 a = glm::clamp(one, turn.minimum, turn.maximum);
  if (a == one) return a;
  const glm::dvec3 b = glm::clamp(other, turn.minimum, turn.maximum);
  const double near_a = std::abs(glm::dot(geometry::quaternion_from_xyz(a), q));
  const double near_b = std::abs(glm::dot(geometry::quaternion_from_xyz(b), q));
  return near_b > near_a ? b : a;
}

bool has_usual_ranges(const rig::Joint& joint) {
  const rig::Joint usual;
  return joint.minimum == usual.minimum && joint.maximum == usual.maximum;
}

Turn make_turn(const Body& body, const rig::Joint& joint, std::size_t number, std::size_t first,
               std::span<const double> values, std::span<const std::size_t> chain) {
  Turn turn;
  turn.joint = number;
  turn.first = first;
  turn.start = geometry::quaternion_from_xyz({values[0], values[1], values[2]});
  turn.minimum = joint.minimum;
  turn.maximum = joint.maximum;
  const glm::dquat to_own = glm::conjugate(body.rest()[number].turn);
  const glm::dvec3 bone = to_own * body.bone(number, chain);
  const auto hinge = body.hinge(number);
  glm::dvec3 first_axis = hinge ? to_own * hinge->axis : across(bone);
  first_axis = geometry::normalized(first_axis - bone * glm::dot(first_axis, bone));
  turn.axes = glm::dmat3(first_axis, glm::cross(bone, first_axis), bone);
  turn.low = {-k_swing_limit, -k_swing_limit, -k_twist_limit};
  turn.high = -turn.low;
  turn.stiffness = {cost_of(k_bend), cost_of(k_bend), cost_of(k_twist)};
  if (hinge) {
    turn.low.x = -(hinge->bent + k_straight);
    turn.high.x = base::k_pi;
    turn.stiffness.y = cost_of(k_off_hinge);
  }
  // Limits are about the rest pose; where the start lies beyond them they begin there.
  const glm::dvec3 so_far = glm::transpose(turn.axes) * log_of(turn.start);
  turn.low = glm::min(turn.low - so_far, glm::dvec3{0});
  turn.high = glm::max(turn.high - so_far, glm::dvec3{0});
  return turn;
}

}  // namespace penpose::joints
