#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "core/intent/chain.h"
#include "core/intent/reader.h"
#include "core/joints/run.h"
#include "core/rig/character_rig.h"

// Joints as the second edition turns them: about axes of their own, single or as runs that bend alike.

namespace penpose::intent {
namespace {

/// One unit of a variable, radians.
constexpr double k_turn = base::k_pi;
/// Difference by which a turn's columns are made, radians.
constexpr double k_step = 1e-4 * base::k_pi;
/// What a run's twist costs beside that of a joint: each of its joints would be twisted.
constexpr double k_bend_stiffness = 0.5;

}  // namespace

void Reader::find_chain() {
  const joints::Body* body = problem_.edition == Edition::second ? whole_.body.get() : nullptr;
  const auto add = [&](const std::vector<posing::CurvePoint>& reference) {
    const auto chain = chain_of(rig_, reference, body);
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
  if (problem_.edition != Edition::second || !whole_.body) return;
  const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig_);
  if (character == nullptr || character->skeleton() == nullptr) return;
  for (std::size_t j = 0; j + 2 < d; ++j) {
    const std::size_t p = parameters_[j];
    const std::size_t joint = whole_.joint[p];
    if (joint == k_no_partner || whole_.group[p] != p || parameters_[j + 1] != p + 1 || parameters_[j + 2] != p + 2)
      continue;
    const rig::Joint& one = character->skeleton()->joints()[joint];
    if (!joints::has_usual_ranges(one)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      turn_of_[j + axis] = turns_.size();
      axis_of_[j + axis] = axis;
      ranges_[j + axis] = k_turn;
    }
    turns_.push_back(joints::make_turn(*whole_.body, one, joint, p, std::span(problem_.start).subspan(p, 3), chain_));
  }
}

void Reader::add_turn(std::size_t variable) {
  const joints::Turn& turn = turns_[turn_of_[variable]];
  const auto axis = static_cast<int>(axis_of_[variable]);
  choices_.limit = joints::k_limit * k_turn * k_turn;
  choices_.soft_low.resize(variable_count(), -1e300);
  choices_.soft_high.resize(variable_count(), 1e300);
  choices_.passed.resize(variable_count(), 0);
  choices_.soft_low[variable] = turn.low[axis] / k_turn;
  choices_.soft_high[variable] = turn.high[axis] / k_turn;
  choices_.low.push_back(-0.75);
  choices_.high.push_back(0.75);
  choices_.stiffness.push_back(turn.stiffness[axis] * k_turn * k_turn);
  // Near rest the three parameters turn about the joint's own axes, and ways along them add up like lengths.
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double part = turn.axes[axis][k] * whole_.movement[turn.first + static_cast<std::size_t>(k)];
    square += part * part;
  }
  choices_.movement.push_back(std::sqrt(square));
}

void Reader::make_runs() {
  if (turns_.empty() || chain_.empty()) return;
  const auto& skeleton = *dynamic_cast<const rig::CharacterRig&>(rig_).skeleton();
  const auto& character = dynamic_cast<const rig::CharacterRig&>(rig_);
  const std::size_t first = character.first_parameter(character.layers().size());
  const auto places = joints::places_of(skeleton, std::span(problem_.start).subspan(first));
  for (const joints::Run& run : joints::runs_of(*whole_.body, places, chain_)) {
    std::array<RunVariable, 3> made;
    std::size_t joints = 0;
    for (const std::size_t joint : run.joints) {
      bool turns = false;
      for (std::size_t v = 0; v < parameters_.size(); ++v) {
        if (turn_of_[v] == k_no_partner || turns_[turn_of_[v]].joint != joint) continue;
        turns = true;
        const joints::Turn& turn = turns_[turn_of_[v]];
        const glm::dvec3 axis = places[joint].turn * turn.axes[static_cast<int>(axis_of_[v])];
        for (int k = 0; k < 3; ++k)
          made[static_cast<std::size_t>(k)].parts.push_back({v, glm::dot(axis, run.axes[k])});
      }
      joints += turns ? 1U : 0U;
    }
    if (joints < 2) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      made[k].twist = k == 2;
      for (const RunVariable::Part& part : made[k].parts) {
        const joints::Turn& turn = turns_[turn_of_[part.variable]];
        double square = 0;
        for (int c = 0; c < 3; ++c) {
          const double one = turn.axes[static_cast<int>(axis_of_[part.variable])][c] *
                             whole_.movement[turn.first + static_cast<std::size_t>(c)];
          square += one * one;
        }
        made[k].movement += std::abs(part.by) * std::sqrt(square);
      }
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
    double stiffness = k_bend_stiffness;
    if (run.twist) {
      for (const RunVariable::Part& part : run.parts) {
        const joints::Turn& turn = turns_[turn_of_[part.variable]];
        stiffness += part.by * part.by * turn.stiffness[static_cast<int>(axis_of_[part.variable])] * k_turn * k_turn;
      }
    }
    choices_.stiffness.push_back(stiffness);
    if (r % 3 != 0) continue;
    Unit unit;
    const std::size_t v = parameters_.size() + r;
    unit.members = {v, v + 1, v + 2};
    unit.count = 3;
    choices_.units.push_back(unit);
  }
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
  system_.positions(trial, positions_);
  for (std::size_t v = 0; v < parameters_.size(); ++v) {
    if (!needed[v]) continue;
    const joints::Turn& turn = turns_[turn_of_[v]];
    const auto axis = static_cast<int>(axis_of_[v]);
    glm::dvec3 other = w[turn_of_[v]];
    const double step = other[axis] > 0 ? -k_step : k_step;
    other[axis] += step;
    const glm::dvec3 angles = joints::angles_of(turn, other);
    for (std::size_t k = 0; k < 3; ++k) trial[turn.first + k] = angles[static_cast<int>(k)];
    system_.positions(trial, moved_);
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

void Reader::mark_passed_limits(std::span<const double> at) {
  for (std::size_t v = 0; v < choices_.passed.size(); ++v) {
    choices_.passed[v] = at[v] < choices_.soft_low[v] ? -1 : at[v] > choices_.soft_high[v] ? 1 : 0;
  }
}

}  // namespace penpose::intent
