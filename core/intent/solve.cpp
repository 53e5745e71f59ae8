#include "core/intent/solve.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/math.h"
#include "core/intent/earlier_lines.h"
#include "core/intent/reading/face_solver.h"
#include "core/intent/reading/limb_solver.h"

namespace penpose::intent {

SolveWorkspace::SolveWorkspace() : buffers_(base::make_hidden<Buffers>()) {}

namespace {

/// How much lower the energy has to be before joints outside of the drawn chain may move.
constexpr double k_beyond_chain = 60.0;
/// A curve with no more squares than this fits as it is aligned: about twice what a steady hand leaves.
constexpr double k_fits = 24.0;
/// What a reading leaves of a curve's squares at most, where it takes the line for what it is.
constexpr double k_near_enough = 0.6;
/// How much lower the energy has to be before a limb leans out of the picture that need not.
constexpr double k_lean_gain = 3.0;
/// How much lower the energy has to be before what was drawn before is read anew, and again for each control taken
/// back; and how much less is asked where what stays needs a control at its limit.
constexpr double k_stay = 10.0, k_stay_at_limit = 16.0;
/// Then its lines have to fit about as well as they did: by this factor of their squares, and this much beyond.
constexpr double k_as_near = 1.2, k_as_near_beyond = 6.0;
/// How near a limit that is, share of the range.
constexpr double k_at_limit = 0.02;
/// A control that is asked for this share of what it can or more hardly is what was meant: a shape that something else
/// takes on is thought of then, even though the line is met, and taken where it is better by this.
constexpr double k_strained = 0.85, k_unstrained_gain = 4.0;

/// A line that is shorter than its limb may show it leaning towards the eye or away from it. The first order of the
/// picture does not tell that of a limb that lies across the view, so that other readings have to begin there.
Reading foreshortened(Reader& reader, LimbSolver& solver, std::size_t drawn, Reading best) {
  const auto fits = [&](const Reading& one) {
    bool all = true;
    for (std::size_t c = 0; c < drawn; ++c) all = all && reader.squares_of(c, one.choice) < k_fits;
    return all;
  };
  if (fits(best) && !reader.leans(best.choice)) return best;
  const double plain = best.energy - k_lean_gain;
  bool left = false;
  for (Choice& lean : reader.leans_in_depth()) {
    const double charge = lean.costs;
    Reading one = solver.read(std::move(lean));
    one.energy += charge;
    if (one.energy < (left ? best.energy : plain) - 1e-9) {
      best = std::move(one);
      left = true;
    }
  }
  solver.match(best);
  return best;
}

/// Whether something is asked for nearly as much as it can.
bool strained(const Reader& reader, const Choice& choice) {
  for (std::size_t i = 0; i < choice.variables.size(); ++i) {
    if (share_of_range(choice.values[i], choice.variables[i], reader.choices()) >= k_strained) return true;
  }
  return false;
}

/// Whether a reading takes the place of one that meets its line at the end of what it can: clearly better, by other
/// controls, which need not go as far.
bool clearly_other(const Reader& reader, const Reading& met, const Reading& other) {
  const auto& units = met.choice.units;
  return other.energy <= met.energy - k_unstrained_gain && !strained(reader, other.choice) &&
         !std::includes(units.begin(), units.end(), other.choice.units.begin(), other.choice.units.end());
}

/// D of each drawn curve as last matched.
std::vector<double> squares_of_all(Reader& reader, const Choice& choice, std::size_t drawn) {
  std::vector<double> squares;
  for (std::size_t c = 0; c < drawn; ++c) squares.push_back(reader.squares_of(c, choice));
  return squares;
}

/// Tries the other ways in which line c may be aligned. Its squares: `asked` before anything moved, `met` by the best
/// reading of all of it.
void realign(Reader& reader, LimbSolver& solver, std::size_t c, double asked, double met, Reading& best) {
  std::size_t chosen = reader.aligned(c);
  const bool beyond = strained(reader, best.choice);
  const bool fits = reader.squares_of(c, best.choice) < k_fits;
  if (reader.alignments(c).size() < 2 || (fits && !beyond)) return;
  for (std::size_t a = 1; a < reader.alignments(c).size(); ++a) {
    // A line that lies beside where it was meant tells a shape that something takes on; thought of where nothing
    // brings the curve near to the line itself, or only at the end of what it can.
    const bool beside = reader.alignments(c)[a].offset_px > 0.0;
    bool is_met = fits;
    if (fits && !beside) continue;
    if (beside) {
      solver.match(best);
      is_met = is_met || met < k_near_enough * asked;
      if (is_met && !beyond) continue;
    }
    reader.align(c, a);
    solver.something = beside;
    if (beside) solver.shape = c;
    Reading one = solver.read();
    solver.shape.reset();
    if (beside) solver.match(one);
    const bool nothing = beside && (one.choice.units.empty() || !reader.takes_shape(c, one.choice));
    solver.something = false;
    const bool instead = !beside || !is_met || clearly_other(reader, best, one);
    if (nothing || !(one.energy < best.energy - 1e-9) || !instead) {
      reader.align(c, chosen);
      continue;
    }
    best = std::move(one);
    chosen = a;
  }
  reader.align(c, chosen);
}

/// The best reading over the ways in which single lines may be aligned.
Reading best_alignment(Reader& reader, LimbSolver& solver, std::size_t drawn) {
  for (std::size_t c = 0; c < drawn; ++c) reader.align(c, 0);
  solver.match({});
  const std::vector<double> asked = squares_of_all(reader, {}, drawn);
  Reading best = solver.read();
  best = foreshortened(reader, solver, drawn, std::move(best));
  // Whether a line is met is told by all of it.
  solver.match(best);
  const std::vector<double> met = squares_of_all(reader, best.choice, drawn);
  for (std::size_t c = 0; c < drawn; ++c) realign(reader, solver, c, asked[c], met[c], best);
  return best;
}

/// Fills in what a pose comes to.
void describe(const rig::Rig& rig, const IntentProblem& problem, Reader& reader, Solution& solution) {
  solution.moved.clear();
  solution.at_limit.clear();
  solution.drawn.clear();
  solution.known.clear();
  for (std::size_t i = 0; i < solution.pose.size(); ++i) {
    if (solution.pose[i] == problem.start[i]) continue;
    solution.moved.push_back(i);
    const rig::Parameter& parameter = rig.parameters()[i];
    if (solution.pose[i] == parameter.minimum || solution.pose[i] == parameter.maximum) solution.at_limit.push_back(i);
  }
  const Reader::Left left = reader.left(solution.pose);
  solution.energy = left.sum;
  solution.max_distance = left.longest;
  for (std::size_t c = 0; c < problem.drawn.size() + problem.known.size(); ++c) {
    CurveLeft one{left.px[c], left.units[c], false};
    if (c < problem.drawn.size()) {
      one.reversed = reader.alignments(c)[reader.aligned(c)].reversed;
      solution.drawn.push_back(one);
    } else {
      solution.known.push_back(one);
    }
  }
}

/// The best reading of strokes along limbs.
Reading read_limbs(Reader& reader, LimbSolver& solver, std::size_t drawn) {
  const std::vector<std::size_t> chain(reader.chain().begin(), reader.chain().end());
  reader.restrict_to(chain);
  Reading reading = best_alignment(reader, solver, drawn);
  if (reading.energy > 2.0 * k_beyond_chain) {
    std::vector<std::size_t> aligned;
    for (std::size_t c = 0; c < drawn; ++c) aligned.push_back(reader.aligned(c));
    reader.restrict_to({});
    Reading all = best_alignment(reader, solver, drawn);
    if (all.energy < reading.energy - k_beyond_chain) {
      reading = std::move(all);
    } else {
      reader.restrict_to(chain);
      for (std::size_t c = 0; c < aligned.size(); ++c) reader.align(c, aligned[c]);
    }
  }
  solver.search(reading);
  return reading;
}

/// A checked problem, whatever is locked. `units`: receives how many moved.
Solution solve_free(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                    const SolveOptions& options, SolveWorkspace& work, std::size_t& units) {
  Reader reader = Reader::of(rig, whole, problem, *options.weights);
  Solution solution;
  solution.variables = reader.parameters().size();
  solution.linear = reader.linear();
  solution.energy_start = reader.left(problem.start).sum;
  Reading reading;
  if (reader.limb()) {
    LimbSolver solver(reader, options, work.buffers());
    reading = read_limbs(reader, solver, problem.drawn.size());
    solution.evaluations = solver.evaluations;
  } else {
    FaceSolver solver(reader, options, work.buffers());
    reading = solver.read();
    const Reading chosen = reading;
    solver.settle(reading);
    solution.evaluations = solver.evaluations;
    if (options.others > 0) {
      solution.others = solver.others(chosen, options.others, solution.probability);
    }
  }
  units = reading.choice.units.size();
  solution.doubt_energy = reading.energy;
  solution.pose = reader.pose_of(reading.choice);
  describe(rig, problem, reader, solution);
  return solution;
}

}  // namespace

IntentProblem as_if_unlocked(const IntentProblem& problem) {
  IntentProblem meant = problem;
  meant.free.insert(meant.free.end(), problem.locked.begin(), problem.locked.end());
  std::stable_sort(meant.free.begin(), meant.free.end());
  meant.free.erase(std::unique(meant.free.begin(), meant.free.end()), meant.free.end());
  meant.locked.clear();
  return meant;
}

bool moves_locked(const IntentProblem& problem, const rig::Pose& pose) {
  return std::any_of(problem.locked.begin(), problem.locked.end(),
                     [&](std::size_t i) { return pose[i] != problem.start[i]; });
}

bool keeps_a_part_of_each(const IntentProblem& problem, const WholeModel& whole, std::span<const std::size_t> moved) {
  const auto locked = [&](std::size_t i) {
    return std::binary_search(problem.locked.begin(), problem.locked.end(), i);
  };
  return std::all_of(moved.begin(), moved.end(), [&](std::size_t i) {
    return !locked(i) || std::any_of(moved.begin(), moved.end(), [&](std::size_t k) {
      const bool one_joint = whole.joint[i] != k_no_partner && whole.joint[i] == whole.joint[k];
      return !locked(k) && (whole.partner[i] == k || one_joint);
    });
  });
}

namespace {

/// A checked problem, what is locked being heeded.
base::Result<Solution> solve_whole(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                                   const SolveOptions& options, SolveWorkspace& work) {
  std::size_t units = 0;
  if (problem.locked.empty()) return solve_free(rig, whole, problem, options, work, units);
  const IntentProblem unlocked = as_if_unlocked(problem);
  if (auto status = check_problem(rig, unlocked); !status) return status.error();
  Solution meant = solve_free(rig, whole, unlocked, options, work, units);
  if (!moves_locked(problem, meant.pose)) {
    std::erase_if(meant.others, [&](const OtherReading& one) { return moves_locked(problem, one.pose); });
    return meant;
  }
  // Of a pair, or of the angles of a joint, the free ones do what they were meant to.
  IntentProblem rest = problem;
  if (keeps_a_part_of_each(problem, whole, meant.moved)) {
    rest.free.clear();
    std::set_difference(meant.moved.begin(), meant.moved.end(), problem.locked.begin(), problem.locked.end(),
                        std::back_inserter(rest.free));
  }
  SolveOptions no_more = options;
  no_more.most_units = std::min(options.most_units, std::max<std::size_t>(1, units));
  Solution without = solve_free(rig, whole, rest, no_more, work, units);
  without.evaluations += meant.evaluations;
  return without;
}

/// Whether a pose takes to the end of its range what an earlier solve did not.
bool goes_to_limit(const rig::Rig& rig, const IntentProblem& problem, const rig::Pose& pose) {
  for (std::size_t i = 0; i < pose.size(); ++i) {
    const rig::Parameter& parameter = rig.parameters()[i];
    if (pose[i] == problem.posed[i]) continue;
    const double end = pose[i] < problem.start[i] ? parameter.minimum : parameter.maximum;
    if (std::abs(pose[i] - end) <= k_at_limit * (parameter.maximum - parameter.minimum)) return true;
  }
  return false;
}

/// A checked problem of which a part was solved for already. What is new moves what it moves, and what was drawn before
/// is read anew with it only where that is clearly better.
base::Result<Solution> solve_with_posed(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                                        const Reader& reader, const SolveOptions& options, SolveWorkspace& work) {
  if (!reader.chain().empty()) return solve_whole(rig, whole, with_earlier_constrained(rig, problem), options, work);
  const IntentProblem part = with_unrelated_constrained(rig, reader, problem);
  if (part.start == problem.posed) return solve_whole(rig, whole, part, options, work);
  auto anew = solve_whole(rig, whole, part, options, work);
  auto held = solve_whole(rig, whole, with_earlier_constrained(rig, part), options, work);
  auto alone = solve_whole(rig, whole, without_earlier(part), options, work);
  if (!anew || !held || !alone) return anew;
  const Fit by_held = fit_of(rig, whole, part, held->pose);
  const Fit by_alone = fit_of(rig, whole, part, alone->pose);
  const bool stays_held = by_held.energy <= by_alone.energy;
  const Fit& stays = stays_held ? by_held : by_alone;
  const Fit by_anew = fit_of(rig, whole, part, anew->pose, &stays);
  bool as_near = true;
  for (std::size_t c = 0; c < part.drawn.size(); ++c)
    as_near =
        as_near && (!part.drawn[c].before || by_anew.squares[c] <= k_as_near * stays.squares[c] + k_as_near_beyond);
  anew->evaluations += held->evaluations + alone->evaluations;
  // Each control that it takes back has to be worth it.
  double gain = k_stay;
  for (std::size_t i = 0; i < part.start.size(); ++i) {
    if (part.posed[i] != part.start[i] && anew->pose[i] == part.start[i]) gain += k_stay;
  }
  if (goes_to_limit(rig, part, (stays_held ? held : alone)->pose)) gain -= k_stay_at_limit;
  if (as_near && by_anew.energy < stays.energy - gain) return anew;
  return stays_held ? held : alone;
}

}  // namespace

base::Result<Solution> solve(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                             const SolveOptions& options, SolveWorkspace& work) {
  if (auto status = check_problem(rig, problem); !status) return status.error();
  if (problem.posed.empty()) return solve_whole(rig, whole, problem, options, work);
  Reader reader = Reader::of(rig, whole, problem);
  auto solution = solve_with_posed(rig, whole, problem, reader, options, work);
  if (solution) describe(rig, problem, reader, *solution);
  return solution;
}

base::Result<std::vector<ExplainedReading>> explain(const rig::Rig& rig, const WholeModel& whole,
                                                    const IntentProblem& problem, const SolveOptions& options,
                                                    SolveWorkspace& work, std::span<const rig::Pose> also) {
  if (auto status = check_problem(rig, problem); !status) return status.error();
  const IntentProblem unlocked = as_if_unlocked(problem);
  Reader reader = Reader::of(rig, whole, unlocked, *options.weights);
  std::vector<ExplainedReading> out;
  if (reader.limb()) return out;
  FaceSolver solver(reader, options, work.buffers());
  const Reading best = solver.read();
  std::vector<Reading> all = solver.all();
  reader.leave_carriers(false);
  const std::vector<std::size_t> whole_lines(reader.line_count(), 0);
  for (const rig::Pose& pose : also) {
    const Choice choice = reader.choice_of(pose);
    for (const auto& aligned : {best.aligned, whole_lines}) {
      const auto same = [&](const Reading& one) { return one.aligned == aligned && one.choice.units == choice.units; };
      if (std::any_of(all.begin(), all.end(), same)) continue;
      solver.align_as({{}, 0.0, aligned});
      all.push_back(solver.matched(choice));
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Reading& a, const Reading& b) { return a.energy < b.energy; });
  double sum = 0;
  for (const Reading& one : all) {
    solver.align_as(one);
    ExplainedReading& explained = out.emplace_back();
    explained.pose = reader.pose_of(one.choice);
    explained.energy = one.energy;
    explained.terms = reader.terms_of(one.choice);
    explained.probability = base::exp(all.front().energy - one.energy);
    sum += explained.probability;
  }
  for (ExplainedReading& one : out) one.probability /= sum;
  return out;
}

base::Result<std::vector<CurveLeft>> left_at_start(const rig::Rig& rig, const WholeModel& whole,
                                                   const IntentProblem& problem) {
  if (auto status = check_problem(rig, problem); !status) return status.error();
  Reader reader = Reader::of(rig, whole, problem);
  const Reader::Left left = reader.left(problem.start);
  std::vector<CurveLeft> out;
  for (std::size_t c = 0; c < problem.drawn.size(); ++c)
    out.push_back({left.px[c], left.units[c], reader.alignments(c).front().reversed, reader.beyond_at_start(c)});
  return out;
}

}  // namespace penpose::intent
