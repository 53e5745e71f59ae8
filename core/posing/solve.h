#pragma once

#include <span>

#include "core/base/hidden.h"
#include "core/base/result.h"
#include "core/posing/problem.h"

namespace penpose::posing {

struct SolveOptions {
  /// The paper's own solver: one simplex over all relevant parameters, tolerance 0.05, nothing beyond.
  bool paper = false;
  /// Finishing for linear rigs (method, section 2); without it only the simplex runs.
  bool finish = true;
  /// lambda of the staying-near term, as a share of the energy at the start divided by the number of variables.
  double near_weight = 1e-4;
  /// A parameter that moves no curve point by more than this share of the rig's size at rest is left out.
  double relevance = 1e-5;
  /// Share of the improvement that the clean-up may lose in all.
  double clean_up = 2e-4;
  std::size_t max_evaluations = 200000;
};

/// Scratch memory of solves; keep it between them.
class SolveWorkspace {
 public:
  SolveWorkspace();
  struct Buffers;
  [[nodiscard]] Buffers& buffers() { return *buffers_; }

 private:
  base::Hidden<Buffers> buffers_;
};

struct Solution {
  rig::Pose pose;               ///< all parameters of the rig
  double energy_start = 0;      ///< E at the start, model units, without the staying-near term
  double energy = 0;            ///< E at the pose, evaluated by the rig itself
  double max_distance = 0;      ///< longest distance left between a point and its target
  std::size_t variables = 0;    ///< parameters in the search, after relevance
  std::size_t evaluations = 0;  ///< of the energy, all stages together
  std::size_t put_back = 0;     ///< parameters that the clean-up reset
  bool linear = false;          ///< solved through the linear form
};

/// Finds the pose that brings the references to their targets (method, section 2). Stops count evaluations, never time:
/// the same problem gives the same bits on any machine. The energy never ends above its start. Errors: those of
/// check_problem.
[[nodiscard]] base::Result<Solution> solve(const rig::Rig& rig, const PoseProblem& problem, const SolveOptions& options,
                                           SolveWorkspace& work);

}  // namespace penpose::posing
