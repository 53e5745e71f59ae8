#include "core/posing/relevance.h"

#include <algorithm>

namespace penpose::posing {
namespace {

struct Effect {
  double largest = 0;
  double sum = 0;
};

/// Displacement of every point from its least to its greatest place is bounded by twice the distance from the first
/// sample.
Effect sampled_effect(CurveSystem& system, std::span<const double> pose, std::size_t parameter) {
  const rig::Parameter& range = system.rig().parameters()[parameter];
  std::vector<ModelPoint> reference(system.point_count());
  std::vector<ModelPoint> moved(system.point_count());
  std::vector<double> farthest(system.point_count(), 0.0);
  rig::Pose trial(pose.begin(), pose.end());
  system.positions(trial, reference);
  constexpr int k_samples = 9;
  for (int s = 0; s < k_samples; ++s) {
    trial[parameter] = range.minimum + (range.maximum - range.minimum) * s / (k_samples - 1);
    system.positions(trial, moved);
    for (std::size_t i = 0; i < moved.size(); ++i)
      farthest[i] = std::max(farthest[i], geometry::distance(moved[i], reference[i]));
  }
  Effect effect;
  for (const double d : farthest) {
    effect.largest = std::max(effect.largest, d);
    effect.sum += d;
  }
  return effect;
}

Effect column_effect(const Residuals& column, std::size_t points, double range) {
  Effect effect;
  for (std::size_t i = 0; i < points; ++i) {
    const double d = range * geometry::length({column[residual_index(i, 0)], column[residual_index(i, 1)],
                                               column[residual_index(i, 2)]});
    effect.largest = std::max(effect.largest, d);
    effect.sum += d;
  }
  return effect;
}

}  // namespace

Relevance relevant_parameters(CurveSystem& system, std::span<const double> pose, std::span<const std::size_t> free,
                              double threshold) {
  std::vector<std::size_t> candidates;
  for (const std::size_t p : free) {
    if (system.moves(p)) candidates.push_back(p);
  }
  auto columns = system.columns(pose, candidates);
  Relevance relevance;
  if (columns) relevance.columns.emplace();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const rig::Parameter& parameter = system.rig().parameters()[candidates[i]];
    const Effect effect =
        columns ? column_effect((*columns)[i].values(), system.point_count(), parameter.maximum - parameter.minimum)
                : sampled_effect(system, pose, candidates[i]);
    if (effect.largest <= threshold) continue;
    relevance.parameters.push_back(candidates[i]);
    relevance.effects.push_back(effect.sum);
    if (columns) relevance.columns->push_back(std::move((*columns)[i]));
  }
  return relevance;
}

}  // namespace penpose::posing
