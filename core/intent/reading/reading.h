#pragma once

#include <vector>

#include "core/intent/choosing/quadratic.h"
#include "core/intent/choosing/selection.h"
#include "core/intent/solve.h"
#include "core/posing/simplex.h"

namespace penpose::intent {

/// The linearisation of a joint is valid near its pose only: the most that an angle may change in a round, share of its
/// range.
inline constexpr double k_trust = 0.2;

struct SolveWorkspace::Buffers {
  Quadratic quadratic;
  posing::SimplexWorkspace simplex;
};

/// One reading of the strokes, and its energy.
struct Reading {
  Choice choice;
  double energy = 0;
  std::vector<std::size_t> aligned = {};  ///< one a drawn curve: its alignment
};

}  // namespace penpose::intent
