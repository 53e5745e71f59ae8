#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/intent/model/whole_model.h"
#include "core/intent/problem.h"

namespace penpose::intent {

struct SolveOptions {
  std::size_t rounds = 3;          ///< of matching and choosing, alternating, where the rig is linear
  std::size_t general_rounds = 8;  ///< where it is not, and each round sees it straight at the pose of the last
  std::size_t rivals = 6;          ///< other readings that are matched by themselves before one is taken
  std::size_t most_units = 24;     ///< controls, pairs or joints that may move, at most
};

/// What one curve came to.
struct CurveLeft {
  double px = 0;     ///< mean distance left in the picture (drawn curves; 0 for known ones)
  double units = 0;  ///< the same in model units
  bool reversed = false;
};

struct Solution {
  rig::Pose pose;                     ///< all parameters of the rig
  std::vector<std::size_t> moved;     ///< parameters that the solve moved, ascending
  std::vector<std::size_t> at_limit;  ///< those of them that stand at an end of their range
  std::vector<CurveLeft> drawn;       ///< one a drawn curve
  std::vector<CurveLeft> known;       ///< one a known curve
  double energy_start = 0;            ///< sum of distances at the start, model units
  double energy = 0;                  ///< the same at the pose
  double max_distance = 0;            ///< longest of them, model units
  double doubt_energy = 0;            ///< what was minimised: squares of doubts and costs of controls, without unit
  std::size_t variables = 0;          ///< parameters that move the curves
  std::size_t evaluations = 0;        ///< of the energy
  bool linear = false;
};

/// Scratch memory, and what is worth keeping of a rig between solves.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;
  struct Buffers;
  [[nodiscard]] Buffers& buffers() { return *buffers_; }

 private:
  std::unique_ptr<Buffers> buffers_;
};

/// The pose that was meant. Minimises, over which controls move and how far,
///
///   sum over curves of nu log(1 + D / nu)  +  sum over the controls that move of their cost (Costs)
///
/// where D are squared distances in widths of doubt: across the drawn line and along it, what points may slide along it
/// taken back (SlidingLine), next to nothing along the ray; nu = 150 makes what no control can reach count little more.
/// Matching and choosing alternate, the values of a choice by least squares within the ranges; downhill simplex then
/// searches the values of the best choice on this energy itself, with its logarithms.
/// Where the strokes mean a control that is locked: of a pair, or of the angles of a joint, what is free does what it
/// was meant to; else the best reading without the locked that moves no more controls.
/// Stops count evaluations, never time. Errors: those of check_problem. `whole` is that of the rig.
[[nodiscard]] base::Result<Solution> solve(const rig::Rig& rig, const WholeModel& whole, const IntentProblem& problem,
                                           const SolveOptions& options, Workspace& work);

/// The problem with what is locked free to move: what the strokes mean by themselves.
[[nodiscard]] IntentProblem as_if_unlocked(const IntentProblem& problem);
/// Whether a pose moves what is locked.
[[nodiscard]] bool moves_locked(const IntentProblem& problem, const rig::Pose& pose);

/// Whether of all that the strokes mean a part is free: of a pair one side, of a joint an angle. `moved`: by the
/// meaning of the strokes, ascending.
[[nodiscard]] bool keeps_a_part_of_each(const IntentProblem& problem, const WholeModel& whole,
                                        std::span<const std::size_t> moved);

/// What is left of each drawn curve at the problem's start, points having slid to where they fit. Errors as solve.
[[nodiscard]] base::Result<std::vector<CurveLeft>> left_at_start(const rig::Rig& rig, const WholeModel& whole,
                                                                 const IntentProblem& problem);

}  // namespace penpose::intent
