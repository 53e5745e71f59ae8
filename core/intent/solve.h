#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/hidden.h"
#include "core/base/result.h"
#include "core/inference/weights.h"
#include "core/intent/model/whole_model.h"
#include "core/intent/problem.h"

namespace penpose::intent {

struct SolveOptions {
  std::size_t rounds = 3;          ///< of alternating matching and choosing, for faces of linear rigs
  std::size_t general_rounds = 4;  ///< for faces of other rigs, linearised anew where joints turned
  std::size_t limb_rounds = 8;     ///< for limbs, linearised in each round at the pose of the last
  std::size_t rivals = 6;          ///< other readings of limbs that are matched on their own before one is taken
  std::size_t most_units = 24;     ///< controls, pairs or joints that may move, at most
  std::size_t others = 0;          ///< of lines on faces: other readings that are kept beside the one taken, at most
  const inference::Weights* weights = &inference::learned_weights();
};

/// Another way to read lines on a face.
struct OtherReading {
  rig::Pose pose;          ///< all parameters of the rig
  double above = 0;        ///< its energy over that of the reading taken
  double probability = 0;  ///< among all readings that were found, those that look alike taken together
};

/// What is left of one curve's error.
struct CurveLeft {
  double px = 0;     ///< mean distance left in the picture (drawn curves; 0 for known ones)
  double units = 0;  ///< the same in model units
  bool reversed = false;
  double beyond_px = 0;  ///< how far the farther end of the drawn line lies from the curve; only of left_at_start
};

struct Solution {
  rig::Pose pose;                     ///< all parameters of the rig
  std::vector<std::size_t> moved;     ///< parameters that the solve moved, ascending
  std::vector<std::size_t> at_limit;  ///< those of them at an end of their range
  std::vector<CurveLeft> drawn;       ///< one a drawn curve
  std::vector<CurveLeft> known;       ///< one a known curve
  double energy_start = 0;            ///< sum of distances at the start, model units
  double energy = 0;                  ///< the same at the pose
  double max_distance = 0;            ///< longest of them, model units
  double doubt_energy = 0;            ///< the minimised value: squares of doubts and costs of controls; dimensionless
  std::size_t variables = 0;          ///< parameters that move the curves
  std::size_t evaluations = 0;        ///< of the energy
  bool linear = false;
  std::vector<OtherReading> others;  ///< the likeliest first, at most SolveOptions::others; no two look alike
  double probability = 1;            ///< of the reading taken, where others were asked for
};

/// Scratch memory, and data of a rig to keep between solves.
class SolveWorkspace {
 public:
  SolveWorkspace();
  struct Buffers;
  [[nodiscard]] Buffers& buffers() { return *buffers_; }

 private:
  base::Hidden<Buffers> buffers_;
};

/// Finds the intended pose. Minimises, over which controls move and how far, what is left of the curves and what the
/// controls cost that move. Squares D of what is left are in widths of doubt: across the drawn line and along it, less
/// what points slide along it (SlidingLine), and with almost no weight along the ray. Lines that do not span what
/// joints carry mean a face: what is left counts by Doubt, controls cost by inference::Weights. Lines along limbs:
///
///   sum over curves of nu log(1 + D / nu)  +  sum over the controls that move of their cost (Costs),  nu = 150
///
/// Matching and choosing alternate; the values of a choice come from least squares within the ranges. Downhill simplex
/// then searches the values of the best choice on this energy itself, with its logarithms.
/// Where the strokes mean a locked control: the free side of a pair, or the free angles of a joint, still move as
/// meant; otherwise the best reading without the locked control that moves no more controls is taken. Stops count
/// evaluations, never time. Errors: those of check_problem. `whole` is that of the rig.
[[nodiscard]] base::Result<Solution> solve(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                                           const SolveOptions& options, SolveWorkspace& work);

/// A reading and the terms of its energy.
struct ExplainedReading {
  rig::Pose pose;          ///< all parameters of the rig
  double energy = 0;       ///< the terms by their weights
  double probability = 0;  ///< among the readings that were found
  inference::Terms terms;
};

/// Returns all readings of lines on a face that the solver found, the best first. It adds a reading for the controls
/// that each pose of `also` moves, with values of its own. Limbs have none. Locked controls count as free, and earlier
/// solutions are ignored. Errors: those of check_problem.
[[nodiscard]] base::Result<std::vector<ExplainedReading>> explain(const rig::Rig& rig, const WholeModel& whole,
                                                                  const IntentProblem& problem,
                                                                  const SolveOptions& options, SolveWorkspace& work,
                                                                  std::span<const rig::Pose> also = {});

/// The problem with its locked controls free: what the strokes alone mean.
[[nodiscard]] IntentProblem as_if_unlocked(const IntentProblem& problem);
/// Whether a pose moves a locked control.
[[nodiscard]] bool moves_locked(const IntentProblem& problem, const rig::Pose& pose);

/// Whether part of what the strokes mean is free: one side of a pair, or an angle of a joint. `moved`: the controls
/// that the strokes mean, ascending.
[[nodiscard]] bool keeps_a_part_of_each(const IntentProblem& problem, const WholeModel& whole,
                                        std::span<const std::size_t> moved);

/// The distance left of each drawn curve at the problem's start, with sliding. Errors as solve.
[[nodiscard]] base::Result<std::vector<CurveLeft>> left_at_start(const rig::Rig& rig, const WholeModel& whole,
                                                                 const IntentProblem& problem);

}  // namespace penpose::intent
