#pragma once

#include <span>
#include <vector>

#include "core/posing/pose_objective.h"

namespace penpose::posing {

struct FinishOptions {
  std::size_t max_iterations = 24;
  double gain_tolerance = 2e-5;  ///< stop when an iteration lowers the value by less than this share of it
};

struct FinishWorkspace {
  std::vector<double> image, trial, step_image, shares, scaled, hessian, gradient, step, at;
  std::vector<std::size_t> active;
};

struct FinishResult {
  double value = 0;
  std::size_t iterations = 0;
  std::size_t evaluations = 0;
};

/// Lowers the convex energy of a linear model further (method, section 2, "Finishing"): iteratively reweighted least
/// squares (Weiszfeld 1937; Lawson 1961), each weighted problem solved within 0..1 by coordinate descent, each step
/// followed by a search along its line. u never gets worse. Precondition: u within 0..1, one value a variable.
FinishResult finish_linear(const LinearModel& model, const FinishOptions& options, std::span<double> u,
                           FinishWorkspace& work);

}  // namespace penpose::posing
