#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/math.h"
#include "core/intent/chain.h"
#include "core/intent/reading/reader.h"
#include "core/joints/run.h"
#include "core/rig/character_rig.h"

// Joints turn about axes of their own, single or as runs that bend alike.

namespace penpose::intent {
namespace {

/// One unit of a variable, radians.
constexpr double k_turn = base::k_pi;
/// Difference by which a turn's columns are made, radians.
constexpr double k_step = 1e-4 * base::k_pi;
/// What the square of a bend costs: no more than what keeps undetermined ones where they are.
constexpr double k_bend_stiffness = 0.5;
/// Bends out of the picture: the line hardly shows them, and few poses that are drawn in one view go far out of it.
constexpr double k_depth = 0.26;  ///< width, radians
constexpr double k_depth_charge = 14.0;
constexpr double k_least_charge = 4.0;  ///< for hinges that bend so and bones that do not lie across the view
constexpr double k_twist_charge = 8.0;
/// A first guess of it, in half circles, and what it costs where it leads away from the eye: limbs that lean forward
/// are drawn from the front.
constexpr double k_lean = 0.22, k_away = 3.0;
/// Turning the joint that a drawn chain begins with swings the limbs that hang on it, too: the legs on the hips.
constexpr double k_others_charge = 20.0;
/// Views whose directions differ by less are one (cosine).
constexpr double k_one_view = 0.99;

/// Of a joint alone beside a run: what one joint does shows better.
constexpr double k_alone = 0.4;

double depth_stiffness(double joints) { return joints * joints * (k_turn / k_depth) * (k_turn / k_depth); }

}  // namespace

void Reader::find_chain() {
  const joints::Body* body = whole_.body.get();
  const auto add = [&](const std::vector<posing::CurvePoint>& reference) {
    const auto chain = chain_of(rig_, reference, body);
    if (!spans(reference, chain)) return;
    chain_.insert(chain_.end(), chain.begin(), chain.end());
  };
  for (const DrawnCurve& curve : problem_.drawn) add(curve.reference);
  for (const KnownCurve& curve : problem_.known) add(curve.reference);
  std::stable_sort(chain_.begin(), chain_.end());
  chain_.erase(std::unique(chain_.begin(), chain_.end()), chain_.end());
}

void Reader::make_turns() {
  const std::size_t d = parameters_.size();
  turn_of_.assign(d, k_no_partner);
  axis_of_.assign(d, 0);
  if (!whole_.body) return;
  const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig_);
  if (character == nullptr || character->skeleton() == nullptr) return;
  const std::size_t first = character->first_parameter(character->layers().size());
  const auto places = joints::places_of(*character->skeleton(), std::span(problem_.start).subspan(first));
  const auto view = only_view();
  for (std::size_t j = 0; j + 2 < d; ++j) {
    const std::size_t p = parameters_[j];
    const std::size_t joint = whole_.joint[p];
    if (joint == k_no_partner || whole_.group[p] != p || parameters_[j + 1] != p + 1 || parameters_[j + 2] != p + 2)
      continue;
    const rig::Joint& one = character->skeleton()->joints()[joint];
    if (!joints::turns_freely(one)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      turn_of_[j + axis] = turns_.size();
      axis_of_[j + axis] = axis;
      ranges_[j + axis] = k_turn;
    }
    turns_.push_back(joints::make_turn(*whole_.body, one, joint, p, std::span(problem_.start).subspan(p, 3),
                                       places[joint], chain_, view));
    if (!limb()) turns_.back().leans.clear();
  }
}

std::optional<ModelVector> Reader::only_view() const {
  if (problem_.drawn.empty() || !problem_.known.empty()) return std::nullopt;
  const geometry::Camera& camera = problem_.drawn.front().camera;
  for (const DrawnCurve& curve : problem_.drawn) {
    if (glm::dot(curve.camera.forward(), camera.forward()) < k_one_view) return std::nullopt;
  }
  return camera.forward();
}

/// Near rest the three parameters turn about the joint's own axes, and ways along them add up like lengths.
double Reader::movement_about(std::size_t variable) const {
  const joints::Turn& turn = turns_[turn_of_[variable]];
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double part =
        turn.axes[static_cast<int>(axis_of_[variable])][k] * whole_.movement[turn.first + static_cast<std::size_t>(k)];
    square += part * part;
  }
  return std::sqrt(square);
}

void Reader::add_turn(std::size_t variable) {
  choices_.low.push_back(-0.75);
  choices_.high.push_back(0.75);
  const joints::Turn& turn = turns_[turn_of_[variable]];
  const bool depth = turn.planar && axis_of_[variable] == 1 && !turn.bends_in_depth;
  choices_.stiffness.push_back(depth ? k_alone * turn.across * depth_stiffness(1) + k_bend_stiffness
                                     : k_bend_stiffness);
  choices_.movement.push_back(movement_about(variable));
}

void Reader::make_runs() {
  if (!limb()) {
    make_joint_pairs();
    return;
  }
  if (turns_.empty() || chain_.empty()) return;
  const auto& skeleton = *dynamic_cast<const rig::CharacterRig&>(rig_).skeleton();
  const auto& character = dynamic_cast<const rig::CharacterRig&>(rig_);
  const std::size_t first = character.first_parameter(character.layers().size());
  const auto places = joints::places_of(skeleton, std::span(problem_.start).subspan(first));
  for (const joints::Run& run : joints::runs_of(*whole_.body, places, chain_, only_view())) {
    std::array<RunVariable, 3> made;
    std::size_t joints = 0;
    for (const std::size_t joint : run.joints) {
      const auto turn = std::find_if(turns_.begin(), turns_.end(), [&](const auto& t) { return t.joint == joint; });
      if (turn == turns_.end()) continue;
      ++joints;
      const glm::dmat3 own = glm::inverse(turn->axes) * glm::mat3_cast(glm::conjugate(places[joint].turn)) * run.axes;
      for (std::size_t v = 0; v < parameters_.size(); ++v) {
        if (turn_of_[v] == k_no_partner || turns_[turn_of_[v]].joint != joint) continue;
        for (int k = 0; k < 3; ++k)
          made[static_cast<std::size_t>(k)].parts.push_back({v, own[k][static_cast<int>(axis_of_[v])]});
      }
    }
    if (joints < 2) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      made[k].joints = joints;
      made[k].planar = run.planar;
      made[k].across = run.across;
      for (const RunVariable::Part& part : made[k].parts)
        made[k].movement += std::abs(part.by) * movement_about(part.variable);
      run_variables_.push_back(std::move(made[k]));
    }
  }
}

void Reader::make_run_units() {
  for (std::size_t r = 0; r < run_variables_.size(); ++r) {
    const RunVariable& run = run_variables_[r];
    choices_.low.push_back(-0.5);
    choices_.high.push_back(0.5);
    choices_.movement.push_back(run.movement);
    const bool depth = run.planar && r % 3 == 1;
    choices_.stiffness.push_back(
        depth ? run.across * depth_stiffness(static_cast<double>(run.joints)) + k_bend_stiffness : k_bend_stiffness);
    if (r % 3 != 0) continue;
    if (!limb()) {
      add_joint_pair(parameters_.size() + r);
      continue;
    }
    add_turn_units(parameters_.size() + r, 3, run.planar, run.across);
  }
}

bool Reader::swings_others(std::size_t joint) const {
  if (chain_.size() < 3 || chain_.front() != joint || whole_.body->branches(joint).size() < 2) return false;
  const std::int32_t parent = whole_.body->parent(joint);
  return parent < 0 || !std::binary_search(chain_.begin(), chain_.end(), static_cast<std::size_t>(parent));
}

void Reader::add_turn_units(std::size_t first, std::size_t count, bool planar, double across) {
  Unit unit;
  unit.members = {first, first + 1, first + 2};
  if (!limb()) {
    for (unit.count = planar ? 1 : 2; unit.count <= count; ++unit.count) {
      charge_face(unit, true);
      choices_.units.push_back(unit);
    }
    return;
  }
  if (first < parameters_.size()) across *= k_alone;
  if (first < parameters_.size() && swings_others(turns_[turn_of_[first]].joint)) unit.charge = k_others_charge;
  if (planar) {
    unit.count = 1;
    choices_.units.push_back(unit);
    unit.charge += k_least_charge + across * (k_depth_charge - k_least_charge);
    if (count > 2) {
      unit.count = 2;
      choices_.units.push_back(unit);
      unit.charge += k_twist_charge;
    }
  }
  unit.count = count;
  choices_.units.push_back(unit);
}

std::vector<std::size_t> Reader::all_bends() const {
  constexpr std::size_t k_most = 12;
  std::vector<std::size_t> bends;
  for (std::size_t u = 0; u < choices_.units.size(); ++u) {
    const Unit& unit = choices_.units[u];
    const std::size_t v = unit.members[0];
    if (unit.count != 1 || v >= parameters_.size() || turn_of_[v] == k_no_partner) continue;
    if (std::binary_search(chain_.begin(), chain_.end(), turns_[turn_of_[v]].joint)) bends.push_back(u);
  }
  if (bends.size() < 2 || bends.size() > k_most) bends.clear();
  return bends;
}

bool Reader::leans(const Choice& choice) const {
  return std::any_of(choice.units.begin(), choice.units.end(),
                     [&](std::size_t u) { return choices_.units[u].count > 1 && choices_.units[u].charge > 0.0; });
}

std::vector<Choice> Reader::leans_in_depth() const {
  std::vector<Choice> leans;
  const auto add = [&](std::size_t unit, double by) {
    const Unit& u = choices_.units[unit];
    for (const double sign : {-1.0, 1.0}) {
      Choice lean;
      lean.units = {unit};
      lean.variables.assign(u.members.begin(), u.members.begin() + u.count);
      lean.values.assign(u.count, 0.0);
      lean.values[1] = sign * by;
      lean.costs = sign > 0 ? k_away : 0.0;
      leans.push_back(std::move(lean));
    }
  };
  std::size_t longest = k_no_partner;
  std::size_t joints = 0;
  for (std::size_t u = 0; u < choices_.units.size(); ++u) {
    const Unit& unit = choices_.units[u];
    const std::size_t v = unit.members[0];
    if (unit.count != 2) continue;
    if (v >= parameters_.size()) {
      if (run_variables_[v - parameters_.size()].joints <= joints) continue;
      joints = run_variables_[v - parameters_.size()].joints;
      longest = u;
    } else if (turn_of_[v] != k_no_partner && turns_[turn_of_[v]].planar &&
               std::binary_search(chain_.begin(), chain_.end(), turns_[turn_of_[v]].joint)) {
      add(u, k_lean);
    }
  }
  if (longest != k_no_partner) add(longest, k_lean / static_cast<double>(joints));
  return leans;
}

std::vector<glm::dvec3> Reader::turned_by(std::span<const double> at) const {
  std::vector<glm::dvec3> w(turns_.size(), glm::dvec3{0});
  const auto add = [&](std::size_t v, double value) {
    if (turn_of_[v] != k_no_partner) w[turn_of_[v]][static_cast<int>(axis_of_[v])] += value * k_turn;
  };
  for (std::size_t v = 0; v < parameters_.size(); ++v) {
    if (at[v] != 0.0) add(v, at[v]);
  }
  for (std::size_t v = parameters_.size(); v < at.size(); ++v) {
    if (at[v] == 0.0) continue;
    for (const RunVariable::Part& part : run_variables_[v - parameters_.size()].parts)
      add(part.variable, part.by * at[v]);
  }
  return w;
}

void Reader::turn_pose(std::span<const double> at, rig::Pose& pose) const {
  const auto w = turned_by(at);
  for (std::size_t t = 0; t < turns_.size(); ++t) {
    if (w[t] == glm::dvec3{0}) continue;
    const glm::dvec3 angles = joints::angles_of(turns_[t], w[t]);
    for (std::size_t k = 0; k < 3; ++k) pose[turns_[t].first + k] = angles[static_cast<int>(k)];
  }
}

void Reader::make_turn_columns(const rig::Pose& pose, std::span<const double> at,
                               std::span<const std::size_t> variables) {
  if (turns_.empty()) return;
  const std::size_t n = start_.size();
  std::vector<bool> needed(parameters_.size(), false);
  for (const std::size_t v : variables) {
    if (v < parameters_.size()) {
      needed[v] = turn_of_[v] != k_no_partner;
    } else {
      for (const RunVariable::Part& part : run_variables_[v - parameters_.size()].parts) needed[part.variable] = true;
    }
  }
  const auto w = turned_by(at);
  rig::Pose trial = pose;
  place(trial, positions_);
  for (std::size_t v = 0; v < parameters_.size(); ++v) {
    if (!needed[v]) continue;
    const joints::Turn& turn = turns_[turn_of_[v]];
    const auto axis = static_cast<int>(axis_of_[v]);
    glm::dvec3 other = w[turn_of_[v]];
    const double step = other[axis] > 0 ? -k_step : k_step;
    other[axis] += step;
    const glm::dvec3 angles = joints::angles_of(turn, other);
    for (std::size_t k = 0; k < 3; ++k) trial[turn.first + k] = angles[static_cast<int>(k)];
    place(trial, moved_);
    for (std::size_t k = 0; k < 3; ++k) trial[turn.first + k] = pose[turn.first + k];
    for (std::size_t i = 0; i < n; ++i) columns_[v * n + i] = (moved_[i] - positions_[i]) * (k_turn / step);
  }
  for (const std::size_t v : variables) {
    if (v < parameters_.size()) continue;
    const std::span column(columns_.data() + v * n, n);
    std::fill(column.begin(), column.end(), ModelVector{0});
    for (const RunVariable::Part& part : run_variables_[v - parameters_.size()].parts) {
      for (std::size_t i = 0; i < n; ++i) column[i] += columns_[part.variable * n + i] * part.by;
    }
  }
}

std::size_t Reader::lean_count() const {
  std::size_t count = 0;
  for (const joints::Turn& turn : turns_) count += turn.leans.size();
  return count;
}

void Reader::look_at_leans(Quadratic& quadratic, std::size_t row, std::span<const double> at) {
  if (turns_.empty()) return;
  const auto w = turned_by(at);
  std::vector<std::size_t> first_row(turns_.size());
  for (std::size_t t = 0; t < turns_.size(); ++t) {
    first_row[t] = row;
    for (const joints::Lean& lean : turns_[t].leans) {
      // A limit that is not passed asks for nothing.
      const double value = glm::dot(lean.along, w[t]);
      const double to = value < lean.low ? lean.low : lean.high;
      if (lean.beyond(w[t]) != 0.0) quadratic.right()[row] = std::sqrt(lean.stiffness) * to;
      ++row;
    }
  }
  const auto add = [&](std::size_t variable, std::size_t turning, double by) {
    const std::size_t t = turn_of_[turning];
    if (t == k_no_partner) return;
    std::size_t r = first_row[t];
    for (const joints::Lean& lean : turns_[t].leans) {
      if ((lean.low == 0.0 && lean.high == 0.0) || lean.beyond(w[t]) != 0.0)
        quadratic.column(variable)[r] +=
            std::sqrt(lean.stiffness) * lean.along[static_cast<int>(axis_of_[turning])] * by * k_turn;
      ++r;
    }
  };
  for (std::size_t v = 0; v < parameters_.size(); ++v) add(v, v, 1.0);
  for (std::size_t r = 0; r < run_variables_.size(); ++r) {
    for (const RunVariable::Part& part : run_variables_[r].parts) add(parameters_.size() + r, part.variable, part.by);
  }
}

double Reader::lean_cost(const Choice& choice) const {
  std::vector<double> at(variable_count(), 0.0);
  for (std::size_t i = 0; i < choice.variables.size(); ++i) at[choice.variables[i]] = choice.values[i];
  const auto w = turned_by(at);
  double sum = 0;
  for (std::size_t t = 0; t < turns_.size(); ++t) sum += turns_[t].cost(w[t]);
  return sum;
}

}  // namespace penpose::intent
