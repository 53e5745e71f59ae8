#include "core/portrait/contour/contour_controls.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/math.h"
#include "core/rig/character_rig.h"

namespace penpose::portrait {
namespace {

/// One unit of a turn's variable, radians.
constexpr double k_half_circle = base::k_pi;
/// What squares cost: of a share of a range, of half circles of a bend in the picture, out of it and of a twist.
constexpr double k_share_stiffness = 3.0, k_bend = 0.5, k_out_of_picture = 200.0, k_twist_cost = 300.0;
/// A joint that turns about other axes than the view's direction, too, costs so much more.
constexpr double k_other_axes = 4.0;
/// A control that one side alone moves costs so much more than both sides together.
constexpr double k_one_side = 1.0;
/// Less of a share of a range is no way.
constexpr double k_least_room = 1e-6;

/// First guesses, shares of a range and half circles.
constexpr std::array<double, 2> k_shares{0.4, 0.9};
constexpr std::array<double, 5> k_bends{0.1, 0.2, 0.33, 0.48, 0.65};
constexpr std::array<double, 3> k_bends_out{0.12, 0.25, 0.38};

}  // namespace

ContourControls::ContourControls(const rig::Rig& rig, const intent::WholeModel& whole, const rig::Pose& start,
                                 std::span<const std::size_t> free, const geometry::Camera& camera)
    : rig_(rig), whole_(whole), start_(start) {
  const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig);
  const rig::Skeleton* skeleton = character != nullptr ? character->skeleton() : nullptr;
  std::vector<joints::Place> places;
  if (skeleton != nullptr && whole.body) {
    const std::size_t first = character->first_parameter(character->layers().size());
    places = joints::places_of(*skeleton, std::span(start).subspan(first));
  }
  std::vector<std::size_t> variable_of(start.size(), k_no_turn);
  for (std::size_t i = 0; i < free.size(); ++i) {
    const std::size_t p = free[i];
    if (!(whole.movement[p] > 0.0) && whole.joint[p] == intent::k_no_partner) continue;
    const std::size_t joint = whole.joint[p];
    if (joint != intent::k_no_partner && !places.empty()) {
      const bool whole_joint = whole.group[p] == p && i + 2 < free.size() && free[i + 2] == p + 2;
      if (whole_joint && joints::turns_freely(skeleton->joints()[joint])) {
        if (whole.movement[p] + whole.movement[p + 1] + whole.movement[p + 2] > 0.0)
          add_joint(p, skeleton->joints()[joint], places[joint], whole, camera);
        i += 2;
        continue;
      }
    }
    const rig::Parameter& parameter = rig.parameters()[p];
    if (!(parameter.maximum - parameter.minimum > k_least_room)) continue;
    variable_of[p] = variables_.size();
    add_control(p);
  }
  for (std::size_t p = 0; p < start.size(); ++p) {
    if (variable_of[p] == k_no_turn) continue;
    const std::size_t partner = whole.partner[p];
    const bool pair = partner != intent::k_no_partner && variable_of[partner] != k_no_turn;
    intent::Unit unit;
    unit.members[0] = variable_of[p];
    unit.charge = pair ? k_one_side : 0.0;
    choices_.units.push_back(unit);
    if (!pair || partner < p) continue;
    unit.members[1] = variable_of[partner];
    unit.count = 2;
    unit.tied = true;
    unit.charge = 0;
    choices_.units.push_back(unit);
  }
}

void ContourControls::add_control(std::size_t parameter) {
  const rig::Parameter& one = rig_.parameters()[parameter];
  const double range = one.maximum - one.minimum;
  variables_.push_back({parameter, k_no_turn, 0});
  choices_.low.push_back((one.minimum - start_[parameter]) / range);
  choices_.high.push_back((one.maximum - start_[parameter]) / range);
  choices_.movement.push_back(whole_.movement[parameter]);
  choices_.stiffness.push_back(k_share_stiffness);
}

void ContourControls::add_joint(std::size_t first, const rig::Joint& joint, const joints::Place& place,
                                const intent::WholeModel& whole, const geometry::Camera& camera) {
  turns_.push_back(joints::make_turn(*whole.body, joint, whole.joint[first], first, std::span(start_).subspan(first, 3),
                                     place, {}, camera.forward()));
  const joints::Turn& turn = turns_.back();
  first_of_turn_.push_back(variables_.size());
  intent::Unit bend, unit;
  unit.count = 3;
  unit.charge = k_other_axes;
  bend.members[0] = variables_.size();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    unit.members[axis] = variables_.size();
    variables_.push_back({first, turns_.size() - 1, axis});
    choices_.low.push_back(-0.75);
    choices_.high.push_back(0.75);
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      const double part = turn.axes[static_cast<int>(axis)][k] * whole.movement[first + static_cast<std::size_t>(k)];
      square += part * part;
    }
    choices_.movement.push_back(std::sqrt(square));
    const bool out = turn.planar && axis == 1 && !turn.bends_in_depth;
    choices_.stiffness.push_back(axis == 2 ? k_twist_cost : out ? k_bend + k_out_of_picture * turn.across : k_bend);
  }
  if (turn.planar) choices_.units.push_back(bend);
  choices_.units.push_back(unit);
}

std::vector<double> ContourControls::values_of(const intent::Choice& choice) const {
  std::vector<double> values(variables_.size(), 0.0);
  for (std::size_t i = 0; i < choice.variables.size(); ++i) values[choice.variables[i]] = choice.values[i];
  return values;
}

glm::dvec3 ContourControls::turned(std::span<const double> values, std::size_t turn) const {
  const std::size_t v = first_of_turn_[turn];
  return glm::dvec3{values[v], values[v + 1], values[v + 2]} * k_half_circle;
}

rig::Pose ContourControls::pose_at(std::span<const double> values) const {
  rig::Pose pose = start_;
  for (std::size_t v = 0; v < variables_.size(); ++v) {
    const Variable& one = variables_[v];
    if (values[v] == 0.0 || one.turn != k_no_turn) continue;
    const rig::Parameter& parameter = rig_.parameters()[one.parameter];
    pose[one.parameter] = std::clamp(start_[one.parameter] + values[v] * (parameter.maximum - parameter.minimum),
                                     parameter.minimum, parameter.maximum);
  }
  for (std::size_t t = 0; t < turns_.size(); ++t) {
    const glm::dvec3 w = turned(values, t);
    if (w == glm::dvec3{0}) continue;
    const glm::dvec3 angles = joints::angles_of(turns_[t], w);
    for (int k = 0; k < 3; ++k) pose[turns_[t].first + static_cast<std::size_t>(k)] = angles[k];
  }
  return pose;
}

rig::Pose ContourControls::pose_of(const intent::Choice& choice) const { return pose_at(values_of(choice)); }

rig::Pose ContourControls::pose_beside(const intent::Choice& choice, std::size_t variable, double change) const {
  std::vector<double> values = values_of(choice);
  values[variable] += change;
  return pose_at(values);
}

double ContourControls::lean_costs(const intent::Choice& choice) const {
  const std::vector<double> values = values_of(choice);
  double sum = 0;
  for (std::size_t t = 0; t < turns_.size(); ++t) {
    const glm::dvec3 w = turned(values, t);
    if (w != glm::dvec3{0}) sum += turns_[t].cost(w);
  }
  return sum;
}

std::vector<std::vector<double>> ContourControls::guesses(std::size_t number) const {
  const intent::Unit& unit = choices_.units[number];
  std::vector<std::vector<double>> out;
  const std::size_t v = unit.members[0];
  if (variables_[v].turn == k_no_turn) {
    for (const double end : {choices_.high[v], choices_.low[v]}) {
      if (std::abs(end) <= k_least_room) continue;
      for (const double share : k_shares) out.emplace_back(unit.count, share * end);
    }
    return out;
  }
  for (const double side : {1.0, -1.0}) {
    if (unit.count == 1 || !turns_[variables_[v].turn].planar) {
      for (const double bend : k_bends) {
        out.emplace_back(unit.count, 0.0);
        out.back()[0] = side * bend;
      }
    }
    if (unit.count == 1) continue;
    for (const double bend : k_bends_out) out.push_back({0.0, side * bend, 0.0});
  }
  return out;
}

}  // namespace penpose::portrait
