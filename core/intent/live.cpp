#include "core/intent/live.h"

#include <algorithm>
#include <cmath>

#include "core/curve/polyline.h"
#include "core/intent/chain.h"
#include "core/intent/choosing/robust_selection.h"
#include "core/intent/earlier_lines.h"
#include "core/intent/reading/reader.h"
#include "core/intent/solve.h"

namespace penpose::intent {
namespace {

/// Units at most while the pen draws.
constexpr std::size_t k_most_units = 12;
/// An angle moves by this share of its range at most in one report.
constexpr double k_live_trust = 0.1;
/// While a part of the line is drawn other joints move only where that lowers the energy by this: a limb does not
/// flicker between readings.
constexpr double k_change = 5.0;
/// And none at all where it lowers it by this.
constexpr double k_rest_again = 60.0;
/// Squares of doubt at which a limb still rests: about what a joint costs.
constexpr double k_rests = 24.0;

/// Other controls follow a string than those that do where that lowers the energy by this.
constexpr double k_lets_go = 4.0;

/// What a value changes by at rest, share of its range.
constexpr double k_at_rest = 1e-5;

bool has_length(std::span<const PxPoint> line) {
  if (line.size() < 2) return false;
  const double drawn = curve::arc_length(line);
  return drawn >= k_shortest_px && drawn <= 1e7;
}

}  // namespace

struct LivePoser::State {
  State(const rig::Rig& r, WholeModel w, IntentProblem p)
      : whole(std::move(w)), rig(r), problem(std::move(p)), pose(problem.start) {
    read_anew();
  }

  WholeModel whole;
  const rig::Rig& rig;
  IntentProblem problem;
  std::unique_ptr<Reader> read;
  std::vector<std::size_t> chain;  ///< once it is known which joints the lines mean
  Quadratic quadratic;
  Choice choice;
  rig::Pose pose;
  std::vector<PxPoint> seen;  ///< the reference before the stroke
  double length = 0;          ///< of it, px
  /// Where controls are locked: what the strokes mean by themselves.
  std::unique_ptr<State> unlocked;

  [[nodiscard]] Reader& reader() { return *read; }
  [[nodiscard]] const Reader& reader() const { return *read; }

  void read_anew() {
    read = std::make_unique<Reader>(Reader::of(rig, whole, problem));
    if (!chain.empty()) read->restrict_to(chain);
    choice = {};
    pose = problem.start;
  }

  /// What the line does not touch from now on.
  void keep(const std::vector<bool>& stays) {
    if (unlocked) unlocked->keep(stays);
    const bool fits = stays.empty() || stays.size() == problem.drawn.front().reference.size();
    if (!fits || problem.drawn.front().stays == stays) return;
    problem.drawn.front().stays = stays;
    read_anew();
  }

  LiveStep step(std::span<const PxPoint> line, const Alignment& alignment) {
    if (!unlocked) return step_free(line, alignment, k_most_units);
    const LiveStep meant = unlocked->step_free(line, alignment, k_most_units);
    if (!moves_locked(problem, unlocked->pose)) {
      choice = {};
      pose = unlocked->pose;
      return meant;
    }
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < pose.size(); ++i) {
      if (unlocked->pose[i] != problem.start[i]) moved.push_back(i);
    }
    if (keeps_a_part_of_each(problem, whole, moved)) {
      choice = {};
      pose = unlocked->pose;
      for (const std::size_t i : problem.locked) pose[i] = problem.start[i];
      return meant;
    }
    const LiveStep without = step_free(line, alignment, std::max<std::size_t>(1, unlocked->choice.units.size()));
    return {true, meant.evaluations + without.evaluations};
  }

  LiveStep step_free(std::span<const PxPoint> line, const Alignment& alignment, std::size_t most_units) {
    if (choice.units.size() > most_units) {
      choice = {};
      reader().weigh_evenly();
    }
    reader().redraw(0, line, alignment);
    if (choice.units.empty() && !reader().all_bends().empty()) {
      // A limb rests while what is drawn of the line may well lie where it is.
      reader().weigh_evenly();
      reader().look(choice, true, quadratic);
      if (quadratic.constant() < k_rests) {
        pose = problem.start;
        return {true, 0};
      }
    }
    if (!reader().limb()) return step_face(most_units);
    // Points slide once the curve has come near: before, the nearest places on the line mean nothing.
    reader().look(choice, !choice.units.empty(), quadratic);
    Selection selection(quadratic, reader().choices(), reader().costs());
    const Choice same = selection.fit(choice.units);
    Choice next = selection.select(same, most_units);
    if (const auto bends = reader().all_bends(); !bends.empty()) {
      Choice other = selection.select(selection.fit(bends), most_units);
      if (other.energy < next.energy - 1e-9 && other.units.size() <= most_units) next = std::move(other);
      const bool part = alignment.reference_to - alignment.reference_from < 1.0;
      const double change = next.units.empty() ? k_rest_again : k_change;
      if (part && !same.units.empty() && next.energy > same.energy - change) next = same;
    }
    move_on(std::move(next));
    reader().weigh(choice);
    return {true, selection.evaluations()};
  }

  LiveStep step_face(std::size_t most_units) {
    reader().look(choice, !choice.units.empty(), quadratic);
    const ReadingCosts costs = reader().reading_costs();
    RobustSelection selection(quadratic, costs, reader().doubt());
    const Choice meant = selection.select(selection.fit(choice.units), most_units);
    reader().settle(true);
    Choice next = selection.fit(meant.units);
    reader().settle(false);
    if (!rests(next)) move_on(std::move(next));
    return {true, selection.evaluations()};
  }

  /// Which controls follow is told by a longer pull, how far by this one.
  LiveStep pull(std::span<const PxPoint> line, std::span<const PxPoint> meant) {
    const auto aligned = [&](std::span<const PxPoint> to) { return alignments(seen, to, 0.0).front(); };
    if (reader().limb()) return step_free(line, aligned(line), k_most_units);
    reader().redraw(0, meant, aligned(meant));
    reader().look({}, false, quadratic);
    const ReadingCosts costs = reader().reading_costs();
    RobustSelection selection(quadratic, costs, reader().doubt());
    const Choice same = selection.fit(choice.units);
    Choice next = selection.select(same, k_most_units);
    if (!choice.units.empty() && next.energy > same.energy - k_lets_go) next = same;
    // Whoever pulls wants something to follow, if less likely than that it stays.
    if (next.units.empty()) next = selection.best_of_one().value_or(next);
    reader().redraw(0, line, aligned(line));
    reader().settle(true);
    // Each look starts where the last one led: the line bends, and points slide along it.
    Choice now;
    constexpr int k_looks_at_line = 3;
    std::size_t evaluations = selection.evaluations();
    for (int i = 0; i < k_looks_at_line; ++i) {
      reader().look(now, i > 0, quadratic);
      const ReadingCosts settled = reader().reading_costs();
      RobustSelection values(quadratic, settled, reader().doubt());
      now = values.fit(next.units);
      evaluations += values.evaluations();
    }
    reader().settle(false);
    if (!rests(now)) move_on(std::move(now));
    return {true, evaluations};
  }

  /// Whether a choice is what it was but for rounding: a face comes to rest.
  [[nodiscard]] bool rests(const Choice& next) const {
    if (next.units != choice.units) return false;
    for (std::size_t i = 0; i < next.values.size(); ++i) {
      if (std::abs(next.values[i] - choice.values[i]) > k_at_rest) return false;
    }
    return true;
  }

  /// Angles go a part of their range in one report.
  void move_on(Choice next) {
    for (std::size_t i = 0; i < next.variables.size(); ++i) {
      if (!reader().limb() && !reader().turns(next.variables[i])) continue;
      const auto at = std::lower_bound(choice.variables.begin(), choice.variables.end(), next.variables[i]);
      const bool had = at != choice.variables.end() && *at == next.variables[i];
      const double was = had ? choice.values[static_cast<std::size_t>(at - choice.variables.begin())] : 0.0;
      next.values[i] = std::clamp(next.values[i], was - k_live_trust, was + k_live_trust);
    }
    choice = std::move(next);
    pose = reader().pose_of(choice);
  }
};

LivePoser::LivePoser(base::Hidden<State> state) : state_(std::move(state)) {}

base::Result<LivePoser> LivePoser::start(const rig::Rig& rig, WholeModel whole, IntentProblem problem) {
  if (problem.drawn.empty())
    return base::Error{"there is no reference curve to match", "", "draw a reference and a target curve"};
  // Until the pen has drawn a line, any line will do.
  DrawnCurve& drawn = problem.drawn.front();
  drawn.target = {{0, 0}, {1, 0}};
  if (auto status = check_problem(rig, problem); !status) return status.error();
  if (!problem.posed.empty()) {
    problem = with_earlier_constrained(rig, problem);
    if (auto status = check_problem(rig, problem); !status) return status.error();
  }

  const bool locked = !problem.locked.empty();
  std::unique_ptr<State> unlocked;
  if (locked) {
    IntentProblem meant = as_if_unlocked(problem);
    if (auto status = check_problem(rig, meant); !status) return status.error();
    unlocked = std::make_unique<State>(rig, whole, std::move(meant));
  }
  auto state = base::make_hidden<State>(rig, std::move(whole), std::move(problem));
  state->seen = state->reader().seen_at_start(0);
  state->length = curve::arc_length<PxPoint>(state->seen);
  const auto bends = state->reader().chain();
  for (State* one : {state.get(), unlocked.get()}) {
    if (one == nullptr || bends.empty()) continue;
    one->chain.assign(bends.begin(), bends.end());
    one->reader().restrict_to(one->chain);
  }
  state->unlocked = std::move(unlocked);
  return LivePoser(std::move(state));
}

LiveStep LivePoser::follow(std::span<const PxPoint> line) {
  State& s = *state_;
  if (!has_length(line)) return {};
  s.keep({});
  const double drawn = curve::arc_length(line);
  Alignment alignment;
  alignment.reversed =
      geometry::distance(line.front(), s.seen.back()) < geometry::distance(line.front(), s.seen.front());
  const double part = std::clamp(drawn / s.length, 0.02, 1.0);
  if (part < 0.98) {
    // The reference's beginning; or its end, which the line was begun at and runs away from.
    alignment.reference_from = alignment.reversed ? 1.0 - part : 0.0;
    alignment.reference_to = alignment.reversed ? 1.0 : part;
  }
  return s.step(line, alignment);
}

LiveStep LivePoser::follow_whole(std::span<const PxPoint> line, const std::vector<bool>& stays) {
  if (!has_length(line)) return {};
  State& s = *state_;
  s.keep(stays);
  return s.step(line, alignments(s.seen, line, 0.0).front());
}

LiveStep LivePoser::pull(std::span<const PxPoint> line, std::span<const PxPoint> meant,
                         const std::vector<bool>& stays) {
  if (!has_length(line) || !has_length(meant)) return {};
  State& s = *state_;
  s.keep(stays);
  if (!s.unlocked) return s.pull(line, meant);
  // What is locked stays, and what else would follow does not make up for it.
  const LiveStep step = s.unlocked->pull(line, meant);
  s.pose = s.unlocked->pose;
  for (const std::size_t i : s.problem.locked) s.pose[i] = s.problem.start[i];
  return step;
}

const rig::Pose& LivePoser::pose() const { return state_->pose; }
std::size_t LivePoser::variables() const { return state_->reader().parameters().size(); }

}  // namespace penpose::intent
