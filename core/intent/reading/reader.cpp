#include "core/intent/reading/reader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/curve/distance.h"
#include "core/curve/pairing.h"

namespace penpose::intent {
namespace {

/// What the square of a variable costs, as shares of ranges: no more than what keeps undetermined ones where they are.
constexpr double k_stiffness = 0.5;
/// The farther a line is from where the curve was seen, the less exactly its shape is meant: width of doubt beside the
/// way that was drawn (a hand's error grows with its way: Weber's law; Schmidt et al., Psychological Review 86, 1979).
constexpr double k_farther = 0.1;
/// But no more than this, beside the width of doubt near by.
constexpr double k_farthest = 1.5;

posing::PoseProblem points_of(const IntentProblem& problem) {
  posing::PoseProblem plain;
  const auto add = [&](const std::vector<posing::CurvePoint>& reference) {
    plain.pairs.push_back({reference, std::vector<ModelPoint>(reference.size(), ModelPoint{0}), {}});
  };
  for (const DrawnCurve& curve : problem.drawn) add(curve.reference);
  for (const KnownCurve& curve : problem.known) add(curve.reference);
  for (const KnownCurve& curve : problem.kept) add(curve.reference);
  plain.free = problem.free;
  plain.start = problem.start;
  return plain;
}

/// How far a line lies from a curve, root mean square over its points to the nearest place of the curve, px.
double way_across(std::span<const PxPoint> curve, std::span<const PxPoint> line) {
  double sum = 0;
  for (const PxPoint& p : line) {
    const double off = curve::distance_to(curve, p);
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(line.size()));
}

}  // namespace

Reader::Reader(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem)
    : rig_(rig), whole_(whole), problem_(problem), system_(rig, points_of(problem)) {
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
    block.alignments =
        intent::alignments(seen(block, start_), curve.target, curve::pairing_distance_px(curve.camera.viewport()));
  }
  for (const auto* curves : {&problem.known, &problem.kept}) {
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
  measure_side_effects();
  all_.resize(parameters_.size());
  for (std::size_t v = all_.size(); v < variable_count(); ++v) all_.push_back(v);
  make_units();
  if (overshoots_tell()) {
    for (Block& block : blocks_) {
      if (block.drawn != nullptr) tell_ends(block);
    }
  }

  // Limbs go far, and their lines are as exact as others.
  if (!chain_.empty()) return;
  if (!problem.posed.empty()) place(problem.posed, positions_);
  for (Block& block : blocks_) {
    if (block.drawn == nullptr) continue;
    block.shown = seen(block, problem.posed.empty() ? start_ : positions_);
    doubt_what_is_far(block, block.drawn->target);
  }
}

void Reader::doubt_what_is_far(Block& block, std::span<const PxPoint> line) const {
  if (block.shown.empty()) return;
  const double far = std::min(k_farther * way_across(block.shown, line), k_farthest * block.drawn->doubt_px);
  block.doubt = std::sqrt(block.drawn->doubt_px * block.drawn->doubt_px + far * far);
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
    choices_.stiffness.push_back(k_stiffness);
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
      if (whole_.joint[p] == k_no_partner) unit.charge = side_effect_cost(j);
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
    unit.charge = std::min(side_effect_cost(j), side_effect_cost(other));
    choices_.units.push_back(unit);
  }
  make_run_units();
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

void Reader::stretch(double ranges) {
  for (std::size_t j = 0; j < parameters_.size(); ++j) {
    const rig::Parameter& parameter = rig_.parameters()[parameters_[j]];
    const double start = problem_.start[parameters_[j]];
    const double low = std::min(0.0, (parameter.minimum - start) / ranges_[j]);
    const double high = std::max(0.0, (parameter.maximum - start) / ranges_[j]);
    // What only goes one way from rest is stretched that way.
    choices_.low[j] = parameter.minimum < parameter.rest ? low - ranges : low;
    choices_.high[j] = parameter.maximum > parameter.rest ? high + ranges : high;
  }
}

std::optional<Choice> meant_without_limits(Reader& reader, Quadratic& quadratic, const Choice& within,
                                           std::size_t most_units, std::size_t& evaluations) {
  // What else comes nearer within the limits has to do so by this, or is not what was meant.
  constexpr double k_clearly = 0.8;
  // How far beyond its limits a control is thought to go, ranges.
  constexpr double k_beyond = 4.0;
  Selection selection(quadratic, reader.choices(), reader.costs());
  const double energy = selection.fit(within.units).energy;
  reader.stretch(k_beyond);
  const Choice meant = selection.select(selection.fit({}), most_units);
  reader.stretch(0.0);
  std::optional<Choice> kept;
  if (!meant.units.empty() && meant.units.size() < within.units.size() && meant.energy < energy) {
    kept = selection.fit(meant.units);
    // Within the limits something else may come nearer by itself.
    selection.forbid_nothing();
    Choice other = selection.select(selection.fit({}), meant.units.size());
    if (!other.units.empty() && other.energy < k_clearly * kept->energy) kept = std::move(other);
  }
  evaluations += selection.evaluations();
  return kept;
}

void Reader::redraw(std::size_t c, std::span<const PxPoint> line, Alignment alignment) {
  Block& block = blocks_[c];
  block.line.emplace(line);
  doubt_what_is_far(block, line);
  block.alignments.assign(1, alignment);
  block.aligned = 0;
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
  const std::size_t n = start_.size();
  columns_.resize(variable_count() * n, ModelVector{0});
  if (linear_) {
    if (const auto columns = system_.columns(pose, parameters_)) {
      for (std::size_t j = 0; j < parameters_.size(); ++j) {
        const posing::Residuals& values = (*columns)[j].values();
        for (std::size_t i = 0; i < n; ++i) {
          columns_[j * n + i] = ModelVector{values[posing::residual_index(i, 0)], values[posing::residual_index(i, 1)],
                                            values[posing::residual_index(i, 2)]} *
                                ranges_[j];
        }
      }
      return;
    }
    linear_ = false;
  }
  // Differences over a ten thousandth of the range, inwards.
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
  make_turn_columns(pose, at, variables);
}

Choice Reader::choice_of(const rig::Pose& pose) const {
  const auto value = [&](std::size_t v) {
    return (pose[parameters_[v]] - problem_.start[parameters_[v]]) / ranges_[v];
  };
  std::vector<bool> left(parameters_.size());
  for (std::size_t v = 0; v < left.size(); ++v) left[v] = value(v) != 0.0;
  Choice choice;
  // Single controls are listed before pairs.
  for (std::size_t u = choices_.units.size(); u-- > 0;) {
    const Unit& unit = choices_.units[u];
    const std::span members(unit.members.data(), unit.count);
    const auto is_left = [&](std::size_t v) { return left[v]; };
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

Reader::Left Reader::left(const rig::Pose& pose) {
  place(pose, positions_);
  Left left;
  for (Block& block : blocks_) {
    double px_sum = 0;
    double sum = 0;
    std::size_t count = 0;
    std::vector<PxPoint> px;
    Matching m;
    if (block.drawn) {
      px = seen(block, positions_);
      m = block.line->match(px, block.alignments[block.aligned], true, block.doubt);
    }
    for (std::size_t i = 0; i < block.count; ++i) {
      const ModelPoint& at = positions_[block.first + i];
      double distance = 0;
      if (block.drawn) {
        if (m.weight[i] == 0.0) continue;
        const double in_picture = geometry::distance(m.target[i], px[i]);
        px_sum += in_picture;
        distance = in_picture * block.drawn->camera.units_per_px(std::max(0.0, block.drawn->camera.depth(at)));
      } else {
        distance = geometry::distance(block.known->target[i], at);
      }
      ++count;
      sum += distance;
      left.longest = std::max(left.longest, distance);
    }
    const double n = static_cast<double>(std::max<std::size_t>(count, 1));
    left.px.push_back(px_sum / n);
    left.units.push_back(sum / n);
    left.sum += sum;
  }
  return left;
}

}  // namespace penpose::intent
