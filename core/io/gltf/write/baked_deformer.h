#pragma once

#include <vector>

#include "core/articulation/deformer.h"
#include "core/rig/blend_shapes.h"

namespace penpose::io {

/// What other programs need beside a deformer's sample at amount 1 (deformer_sample.h) to show it at every amount: the
/// displacement at amount a is a times the sample plus the sum of weight(k, a) times target k.
struct BakedDeformer {
  std::vector<rig::BlendShape> targets;      ///< over the deformer's vertices; their parameters have no name yet
  std::vector<double> amounts;               ///< ascending, evenly spaced over the deformer's range
  std::vector<std::vector<double>> weights;  ///< one list a target, one a amount
  double error = 0;  ///< farthest that a vertex is off at the amounts and half-way between, model units

  /// Precondition: k is a target. Amounts beyond the range count as its ends.
  [[nodiscard]] double weight(std::size_t k, double amount) const;
};

/// Finds as many targets as keep every vertex within `tolerance` (model units) of the deformer at every amount, but at
/// most `most`: of what is left at the amounts, the worst becomes the next target and is taken out of all (a greedy
/// reduced basis). A deformer that goes straight needs none; one that only turns needs one.
/// Weights lie within 0..1, because programs clamp them: a target that would be taken away is there a second time,
/// turned round.
[[nodiscard]] BakedDeformer bake_deformer(const articulation::Deformer& deformer, double tolerance,
                                          std::size_t most = 12);

}  // namespace penpose::io
