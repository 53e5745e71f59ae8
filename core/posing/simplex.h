#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/posing/objective.h"

namespace penpose::posing {

struct SimplexOptions {
  double step = 0.15;             ///< first edge length, share of a variable's range
  double size_tolerance = 1e-4;   ///< stop when every vertex is this near to the best one (share of the range) ...
  double value_tolerance = 1e-6;  ///< ... and the values differ by less than this share of the best value
  double travel_tolerance = 0;    ///< the paper's rule: stop when an iteration moves its vertex by less; 0: not used
  std::size_t max_evaluations = 1000000;  ///< never exceeded, but the first simplex takes one more than variables
  bool adaptive = true;                   ///< coefficients that depend on the dimension (Gao and Han 2012)
};

/// Scratch memory, worth keeping between runs.
struct SimplexWorkspace {
  std::vector<double> vertices, images, values;
  std::vector<double> vertex_sum, image_sum;
  std::vector<double> trial, trial_image, second, second_image;
};

struct SimplexResult {
  double value = 0;
  std::size_t evaluations = 0;
};

/// Downhill simplex (Nelder and Mead 1965) within 0..1: a trial outside is clamped to the box. Starts at u with one
/// more vertex a variable, each moved by `step` away from the nearer end of its range; leaves the best point and its
/// image in u and image. Never returns a point worse than its start. Precondition: u within 0..1, image made for u
/// (size image_size()).
SimplexResult run_simplex(Objective& objective, const SimplexOptions& options, std::span<double> u,
                          std::span<double> image, SimplexWorkspace& work);

}  // namespace penpose::posing
