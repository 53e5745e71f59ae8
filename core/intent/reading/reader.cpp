#include "core/intent/reading/reader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/curve/distance.h"
#include "core/curve/pairing.h"
#include "core/intent/reading/still_points.h"

namespace penpose::intent {
namespace {

/// What the square of a variable costs, as shares of ranges: no more than what keeps undetermined ones where they are.
constexpr double k_stiffness = 0.5;

std::vector<KnownCurve> still_points_of(const rig::Rig& rig, const IntentProblem& problem) {
  std::vector<KnownCurve> still;
  for (const DrawnCurve& curve : problem.drawn) {
    if (auto one = still_points(rig, problem.start, curve)) still.push_back(std::move(*one));
  }
  return still;
}

posing::PoseProblem points_of(const IntentProblem& problem, const std::vector<KnownCurve>& still) {
  posing::PoseProblem plain;
  const auto add = [&](const std::vector<posing::CurvePoint>& reference) {
    plain.pairs.push_back({reference, std::vector<ModelPoint>(reference.size(), ModelPoint{0}), {}});
  };
  for (const DrawnCurve& curve : problem.drawn) add(curve.reference);
  for (const KnownCurve& curve : problem.known) add(curve.reference);
  for (const KnownCurve& curve : problem.kept) add(curve.reference);
  for (const KnownCurve& curve : still) add(curve.reference);
  plain.free = problem.free;
  plain.start = problem.start;
  return plain;
}

}  // namespace

double Reader::way_across(std::span<const PxPoint> curve, std::span<const PxPoint> line) {
  double sum = 0;
  for (const PxPoint& p : line) {
    const double off = curve::distance_to(curve, p);
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(line.size()));
}

Reader Reader::of(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                  const inference::Weights& weights) {
  Reader reader(rig, whole, problem, weights);
  if (weights.follows == 0.0 || reader.limb() || reader.others_follow()) return reader;
  return Reader(rig, whole, problem, weights, true);
}

Reader::Reader(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
               const inference::Weights& weights, bool any_span)
    : rig_(rig),
      whole_(whole),
      problem_(problem),
      still_(still_points_of(rig, problem)),
      any_span_(any_span),
      weights_(weights),
      system_(rig, points_of(problem, still_)) {
  std::size_t first = 0;
  const auto add = [&](const std::vector<posing::CurvePoint>& reference) -> Block& {
    Block block;
    block.first = first;
    block.count = reference.size();
    first += block.count;
    blocks_.push_back(std::move(block));
    return blocks_.back();
  };
  start_.resize(system_.point_count());
  positions_.resize(start_.size());
  moved_.resize(start_.size());
  place(problem.start, start_);
  for (const DrawnCurve& curve : problem.drawn) {
    Block& block = add(curve.reference);
    block.drawn = &curve;
    block.doubt = curve.doubt_px;
    block.line.emplace(curve.target);
    block.alignments = intent::alignments(seen(block, start_), curve.target,
                                          curve::pairing_distance_px(curve.camera.viewport()), weights);
    // A line that corrects a part goes on in what it leaves as it is: all of the reference is meant.
    if (!curve.stays.empty()) block.alignments.resize(1);
  }
  for (const auto* curves : {&problem.known, &problem.kept, &std::as_const(still_)}) {
    for (const KnownCurve& curve : *curves) {
      Block& block = add(curve.reference);
      block.known = &curve;
      block.doubt = curve.doubt;
    }
  }

  std::vector<std::size_t> candidates;
  for (const std::size_t p : problem.free) {
    const rig::Parameter& parameter = rig.parameters()[p];
    if (system_.moves(p) && parameter.maximum > parameter.minimum) candidates.push_back(p);
  }
  parameters_ = candidates;
  for (const std::size_t p : parameters_) ranges_.push_back(rig.parameters()[p].maximum - rig.parameters()[p].minimum);
  for (std::size_t j = 0; j < parameters_.size(); ++j) all_.push_back(j);
  find_chain();
  make_turns();
  linear_ = true;
  make_columns(problem.start, std::vector<double>(parameters_.size(), 0.0), all_);

  // Parameters that move no point by a hundred thousandth of the curves' extent are left out.
  geometry::Box box;
  for (const ModelPoint& p : start_) box.add(p);
  const double least = 1e-5 * box.diagonal();
  const std::size_t n = start_.size();
  std::vector<std::size_t> kept;
  std::vector<double> kept_ranges;
  std::vector<std::size_t> kept_turns;
  std::vector<std::size_t> kept_axes;
  std::vector<ModelVector> kept_columns;
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    const std::span column(columns_.data() + j * n, n);
    const bool moves = std::any_of(column.begin(), column.end(), [&](const ModelVector& v) {
      return geometry::length(v) > least && std::isfinite(v.x + v.y + v.z);
    });
    if (!moves) continue;
    kept.push_back(parameters_[j]);
    kept_ranges.push_back(ranges_[j]);
    kept_turns.push_back(turn_of_[j]);
    kept_axes.push_back(axis_of_[j]);
    kept_columns.insert(kept_columns.end(), column.begin(), column.end());
  }
  parameters_ = std::move(kept);
  ranges_ = std::move(kept_ranges);
  columns_ = std::move(kept_columns);
  turn_of_ = std::move(kept_turns);
  axis_of_ = std::move(kept_axes);
  make_runs();
  columns_at_.clear();  // those of runs are to be made
  measure_side_effects();
  if (!limb()) {
    group_curves();
    measure_groups();
    measure_fields();
    for (std::size_t p = 0; p < problem.start.size(); ++p) {
      const rig::Parameter& parameter = rig.parameters()[p];
      const double range = parameter.maximum - parameter.minimum;
      shares_at_start_.push_back(range > 0.0 ? (problem.start[p] - parameter.rest) / range : 0.0);
    }
    measure_symmetry();
  }
  all_.resize(parameters_.size());
  for (std::size_t v = all_.size(); v < variable_count(); ++v) all_.push_back(v);
  make_units();
  if (!limb()) {
    for (Block& block : blocks_) {
      // How much of a shape a line tells is found with the scale of doubt, and where it lies is always meant.
      std::erase_if(block.alignments, [](const Alignment& one) { return one.offset_px > 0.0; });
      for (Alignment& one : block.alignments) one.slide = weights_.slide;
    }
  }
  if (overshoots_tell()) {
    for (Block& block : blocks_) {
      if (block.drawn != nullptr) tell_ends(block);
    }
  }

  // Limbs go far, and their lines are as exact as others.
  if (!limb()) measure_asked();
}

void Reader::measure_asked() {
  energy_at(problem_.start);
  std::fill(asked_.begin(), asked_.end(), 0.0);
  for (std::size_t c = 0; c < told_count(); ++c) {
    double& asked = asked_[doubt_.group_of(c)];
    asked = std::max(asked, squares(blocks_[c], positions_));
  }
}

void Reader::place(const rig::Pose& pose, std::vector<ModelPoint>& out) {
  system_.positions(pose, out);
  std::size_t first = 0;  // drawn curves come first
  for (const DrawnCurve& curve : problem_.drawn) {
    for (std::size_t i = 0; i < curve.aside.size(); ++i) out[first + i] += curve.aside[i];
    first += curve.reference.size();
  }
}

void Reader::make_units() {
  const std::size_t d = parameters_.size();
  for (std::size_t j = 0; j < d; ++j) {
    const std::size_t p = parameters_[j];
    if (turn_of_[j] != k_no_partner) {
      add_turn(j);
      continue;
    }
    const rig::Parameter& parameter = rig_.parameters()[p];
    choices_.low.push_back(std::min(0.0, (parameter.minimum - problem_.start[p]) / ranges_[j]));
    choices_.high.push_back(std::max(0.0, (parameter.maximum - problem_.start[p]) / ranges_[j]));
    choices_.movement.push_back(whole_.movement[p]);
    choices_.stiffness.push_back(limb() ? k_stiffness : stiffness(false));
  }
  const auto variable_of = [&](std::size_t p) -> std::size_t {
    const auto at = std::lower_bound(parameters_.begin(), parameters_.end(), p);
    return at != parameters_.end() && *at == p ? static_cast<std::size_t>(at - parameters_.begin()) : k_no_partner;
  };
  for (std::size_t j = 0; j < d;) {
    const std::size_t p = parameters_[j];
    Unit unit;
    unit.members[0] = j;
    if (whole_.joint[p] != k_no_partner) {
      while (unit.count < 3 && j + unit.count < d && whole_.group[parameters_[j + unit.count]] == whole_.group[p]) {
        unit.members[unit.count] = j + unit.count;
        ++unit.count;
      }
    }
    if (turn_of_[j] != k_no_partner) {
      const joints::Turn& turn = turns_[turn_of_[j]];
      add_turn_units(j, unit.count, turn.planar && axis_of_[j] == 0, turn.bends_in_depth ? 0.0 : turn.across);
    } else {
      if (limb()) {
        unit.charge = whole_.joint[p] == k_no_partner ? side_effect_cost(j) : 0.0;
      } else {
        charge_face(unit);
      }
      choices_.units.push_back(unit);
    }
    j += unit.count;
  }
  for (std::size_t j = 0; j < d; ++j) {
    const std::size_t partner = whole_.partner[parameters_[j]];
    if (whole_.joint[parameters_[j]] != k_no_partner || partner == k_no_partner) continue;
    const std::size_t other = variable_of(partner);
    if (other == k_no_partner || other <= j) continue;
    // Of a pair that the strokes see one side of, that side is meant.
    constexpr double k_one_side = 0.1;
    if (std::min(curve_displacements_[j], curve_displacements_[other]) <
        k_one_side * std::max(curve_displacements_[j], curve_displacements_[other]))
      continue;
    Unit unit;
    unit.members = {j, other, 0};
    unit.count = 2;
    unit.tied = true;
    if (limb()) {
      unit.charge = std::min(side_effect_cost(j), side_effect_cost(other));
    } else {
      charge_face(unit);
    }
    choices_.units.push_back(unit);
  }
  make_run_units();
  if (!limb()) forgive_carriers();
}

void Reader::restrict_to(std::span<const std::size_t> joints) {
  choices_ = {};
  make_units();
  if (joints.empty()) return;
  std::erase_if(choices_.units, [&](const Unit& unit) {
    if (unit.members[0] >= parameters_.size()) return false;  // runs are within the chain
    const std::size_t joint = whole_.joint[parameters_[unit.members[0]]];
    return joint != k_no_partner && std::find(joints.begin(), joints.end(), joint) == joints.end();
  });
}

void Reader::redraw(std::size_t c, std::span<const PxPoint> line, Alignment alignment) {
  Block& block = blocks_[c];
  block.line.emplace(line);
  if (!limb()) alignment.slide = weights_.slide;
  block.alignments.assign(1, alignment);
  block.aligned = 0;
  if (!limb()) measure_asked();
}

std::vector<PxPoint> Reader::seen(const Block& block, std::span<const ModelPoint> positions) const {
  std::vector<PxPoint> out(block.count);
  for (std::size_t i = 0; i < block.count; ++i) {
    // A point that a pose takes behind the eye is seen at the edge of what is seen at all; check_problem refuses those
    // that start there.
    const auto px = block.drawn->camera.project(positions[block.first + i]);
    out[i] = px ? *px : PxPoint{-1e6, -1e6};
  }
  return out;
}

void Reader::make_columns(const rig::Pose& pose, std::span<const double> at, std::span<const std::size_t> variables) {
  columns_.resize(variable_count() * start_.size(), ModelVector{0});
  if (linear_) {
    if (const auto columns = system_.columns(pose, parameters_)) {
      for (std::size_t j = 0; j < parameters_.size(); ++j) fill_column(j, (*columns)[j].values());
      return;
    }
    linear_ = false;
  }
  if (!limb() && make_face_columns(pose, at, variables)) return;
  make_differences(pose, variables);
  make_turn_columns(pose, at, variables);
}

bool Reader::make_face_columns(const rig::Pose& pose, std::span<const double> at,
                               std::span<const std::size_t> variables) {
  // Shapes act in a linear way while joints stay.
  const auto is_joint = [&](std::size_t p) { return whole_.joint[p] != k_no_partner; };
  bool stays = columns_at_.size() == pose.size();
  for (std::size_t p = 0; p < pose.size() && stays; ++p) stays = !is_joint(p) || pose[p] == columns_at_[p];
  if (stays) return true;
  std::vector<std::size_t> shapes;
  std::copy_if(parameters_.begin(), parameters_.end(), std::back_inserter(shapes),
               [&](std::size_t p) { return !is_joint(p); });
  const auto columns = system_.columns(pose, shapes);
  if (!columns) return false;
  std::size_t next = 0;
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    if (!is_joint(parameters_[j])) fill_column(j, (*columns)[next++].values());
  }
  std::vector<std::size_t> others;
  std::copy_if(variables.begin(), variables.end(), std::back_inserter(others),
               [&](std::size_t v) { return v < parameters_.size() && is_joint(parameters_[v]); });
  make_differences(pose, others);
  make_turn_columns(pose, at, variables);
  columns_at_ = variables.size() == variable_count() ? pose : rig::Pose{};
  return true;
}

void Reader::fill_column(std::size_t j, const posing::Residuals& values) {
  const std::size_t n = start_.size();
  for (std::size_t i = 0; i < n; ++i) {
    columns_[j * n + i] = ModelVector{values[posing::residual_index(i, 0)], values[posing::residual_index(i, 1)],
                                      values[posing::residual_index(i, 2)]} *
                          ranges_[j];
  }
}

void Reader::make_differences(const rig::Pose& pose, std::span<const std::size_t> variables) {
  // Differences over a ten thousandth of the range, inwards.
  const std::size_t n = start_.size();
  rig::Pose trial = pose;
  place(trial, positions_);
  for (const std::size_t j : variables) {
    if (j >= parameters_.size() || turn_of_[j] != k_no_partner) continue;
    const std::size_t p = parameters_[j];
    const double middle = 0.5 * (rig_.parameters()[p].minimum + rig_.parameters()[p].maximum);
    const double step = pose[p] > middle ? -1e-4 : 1e-4;
    trial[p] = pose[p] + step * ranges_[j];
    place(trial, moved_);
    trial[p] = pose[p];
    for (std::size_t i = 0; i < n; ++i) columns_[j * n + i] = (moved_[i] - positions_[i]) * (1.0 / step);
  }
}

Choice Reader::choice_of(const rig::Pose& pose) const {
  const auto value = [&](std::size_t v) {
    return (pose[parameters_[v]] - problem_.start[parameters_[v]]) / ranges_[v];
  };
  std::vector<bool> left(parameters_.size());
  for (std::size_t v = 0; v < left.size(); ++v) left[v] = value(v) != 0.0;
  Choice choice;
  // Single controls are listed before pairs, joints with few angles before those with more.
  for (std::size_t u = choices_.units.size(); u-- > 0;) {
    const Unit& unit = choices_.units[u];
    const std::span members(unit.members.data(), unit.count);
    const auto is_left = [&](std::size_t v) { return v < left.size() && left[v]; };
    if (unit.tied ? !std::all_of(members.begin(), members.end(), is_left)
                  : std::none_of(members.begin(), members.end(), is_left))
      continue;
    choice.units.push_back(u);
    for (const std::size_t v : members) {
      left[v] = false;
      choice.variables.push_back(v);
    }
  }
  std::reverse(choice.units.begin(), choice.units.end());
  std::stable_sort(choice.variables.begin(), choice.variables.end());
  for (const std::size_t v : choice.variables) choice.values.push_back(value(v));
  return choice;
}

rig::Pose Reader::pose_of(const Choice& choice) const {
  rig::Pose pose = problem_.start;
  for (std::size_t i = 0; i < choice.variables.size(); ++i) {
    const std::size_t v = choice.variables[i];
    if (choice.values[i] == 0.0 || v >= parameters_.size() || turn_of_[v] != k_no_partner) continue;
    const std::size_t p = parameters_[v];
    const rig::Parameter& parameter = rig_.parameters()[p];
    pose[p] = std::clamp(problem_.start[p] + choice.values[i] * ranges_[v], parameter.minimum, parameter.maximum);
  }
  if (!turns_.empty()) {
    std::vector<double> at(variable_count(), 0.0);
    for (std::size_t i = 0; i < choice.variables.size(); ++i) at[choice.variables[i]] = choice.values[i];
    turn_pose(at, pose);
  }
  return pose;
}

}  // namespace penpose::intent
