#pragma once

#include <span>
#include <vector>

#include "core/posing/pose_objective.h"
#include "core/posing/simplex.h"

namespace penpose::posing {

struct StageOptions {
  std::size_t whole_below = 8;   ///< up to this many variables are searched together before any stage
  std::size_t stage_size = 6;    ///< most variables of one stage
  double first_step = 0.25;      ///< edge of the first simplex, share of a variable's range
  double gain_tolerance = 1e-4;  ///< stop when a whole sweep, or a restart, gains less than this share of the value
  std::size_t max_sweeps = 40;
  std::size_t max_evaluations = 200000;  ///< never exceeded: without room for another simplex the search ends
};

struct StageWorkspace {
  SimplexWorkspace simplex;
  std::vector<double> u, image;
};

struct StageResult {
  double value = 0;
  std::size_t evaluations = 0;
  std::size_t sweeps = 0;
};

/// Downhill simplex for any number of variables. Few are searched together, restarting from the best point with a fresh
/// simplex until a restart no longer gains. Many are searched in stages, an idea of Rowan's subplex (1990): ranked by
/// effect, a few variables at a time in descending order, sweep after sweep until a whole sweep gains nothing.
/// u never gets worse. Precondition: u and effects have one value a variable.
StageResult run_stages(PoseObjective& objective, std::span<const double> effects, const StageOptions& options,
                       std::span<double> u, StageWorkspace& work);

}  // namespace penpose::posing
