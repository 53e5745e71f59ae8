#include "core/joints/turn.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "core/geometry/rotation.h"

namespace penpose::joints {
namespace {

// Widths of what is usual, radians: 1 / width squared is what the square of a turn costs.
constexpr double k_twist = 0.12;      ///< about the bone's own axis: no stroke along it shows that
constexpr double k_off_hinge = 0.7;   ///< across a hinge
constexpr double k_limit = 0.14;      ///< beyond a limit
constexpr double k_swing_most = 1.4;  ///< from the rest pose: bends that are usual at all
constexpr double k_twist_most = 0.5;
constexpr double k_straight = 0.1;    ///< a hinge gives by this beyond the straight limb
constexpr double k_least_room = 0.5;  ///< of a range, radians: joints with less turn by their angles alone
constexpr double k_aligned = 0.7;     ///< cosine between a hinge and the axis that it is
/// Bones that point more than this towards the eye or away from it do not bend within the picture (sine).
constexpr double k_least_seen_turn = 0.3;

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

double Lean::beyond(const glm::dvec3& w) const {
  const double value = glm::dot(along, w);
  return value < low ? value - low : value > high ? value - high : 0.0;
}

double Turn::cost(const glm::dvec3& w) const {
  double sum = 0;
  for (const Lean& lean : leans) {
    const double beyond = lean.beyond(w);
    sum += lean.stiffness * beyond * beyond;
  }
  return sum;
}

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

bool turns_freely(const rig::Joint& joint) {
  const glm::dvec3 room = joint.maximum - joint.minimum;
  return std::min({room.x, room.y, room.z}) >= k_least_room;
}

Turn make_turn(const Body& body, const rig::Joint& joint, std::size_t number, std::size_t first,
               std::span<const double> values, const Place& place, std::span<const std::size_t> chain,
               const std::optional<ModelVector>& view) {
  Turn turn;
  turn.joint = number;
  turn.first = first;
  turn.start = geometry::quaternion_from_xyz({values[0], values[1], values[2]});
  turn.minimum = joint.minimum;
  turn.maximum = joint.maximum;
  const glm::dquat to_own = glm::conjugate(body.rest()[number].turn);
  const glm::dvec3 bone = to_own * body.bone(number, chain);
  const auto hinge = body.hinge(number);
  // Within the picture a bone turns about the view's direction, so that what is drawn turns as a whole.
  const glm::dvec3 across_bone = hinge ? to_own * hinge->axis : across(bone);
  turn.axes = glm::dmat3(across_bone, glm::cross(bone, across_bone), bone);
  if (view) {
    const glm::dvec3 seen = glm::conjugate(place.turn) * *view;
    const glm::dvec3 out = glm::cross(bone, seen);
    turn.planar = geometry::length(out) > k_least_seen_turn;
    turn.across = std::max(0.0, 1.0 - 2.0 * std::abs(glm::dot(bone, seen)));
    if (turn.planar) turn.axes = glm::dmat3(seen, geometry::normalized(out), bone);
  }

  // Limits are about the rest pose; where the start lies beyond them they begin there.
  const glm::dvec3 so_far = log_of(turn.start);
  const auto limit = [&](const glm::dvec3& own, double low, double high) {
    const double start = glm::dot(own, so_far);
    turn.leans.push_back(
        {glm::transpose(turn.axes) * own, cost_of(k_limit), std::min(low - start, 0.0), std::max(high - start, 0.0)});
  };
  turn.leans.push_back({{0, 0, 1}, cost_of(k_twist), 0, 0});
  // A file that gives ranges of its own says more than the shape does.
  const rig::Joint usual;
  if (joint.minimum != usual.minimum || joint.maximum != usual.maximum) return turn;
  limit(bone, -k_twist_most, k_twist_most);
  if (hinge) {
    const glm::dvec3 about = to_own * hinge->axis;
    const glm::dvec3 off = glm::cross(bone, about);
    turn.bends_in_depth = turn.planar && std::abs(glm::dot(turn.axes[1], about)) > k_aligned;
    turn.leans.push_back({glm::transpose(turn.axes) * off, cost_of(k_off_hinge), 0, 0});
    limit(about, -(hinge->bent + k_straight), base::k_pi);
  } else {
    limit(across_bone, -k_swing_most, k_swing_most);
    limit(glm::cross(bone, across_bone), -k_swing_most, k_swing_most);
  }
  return turn;
}

}  // namespace penpose::joints
