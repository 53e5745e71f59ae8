#include "core/posing/staged_simplex.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace penpose::posing {
namespace {

/// One simplex over the subset; moves u there. Returns the value reached.
double search(PoseObjective& objective, std::span<const std::size_t> subset, const SimplexOptions& simplex,
              std::span<double> u, StageWorkspace& work, StageResult& result) {
  objective.select(subset, u);
  work.u.resize(subset.size());
  work.image.resize(objective.image_size());
  for (std::size_t i = 0; i < subset.size(); ++i) work.u[i] = u[subset[i]];
  objective.make_image(work.u, work.image);
  const SimplexResult found = run_simplex(objective, simplex, work.u, work.image, work.simplex);
  for (std::size_t i = 0; i < subset.size(); ++i) u[subset[i]] = work.u[i];
  result.evaluations += found.evaluations;
  return found.value;
}

}  // namespace

StageResult run_stages(PoseObjective& objective, std::span<const double> effects, const StageOptions& options,
                       std::span<double> u, StageWorkspace& work) {
  StageResult result;
  const std::size_t d = u.size();
  std::vector<std::size_t> order(d);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return effects[a] > effects[b]; });
  const std::size_t stages = d <= options.whole_below ? 1 : (d + options.stage_size - 1) / options.stage_size;

  SimplexOptions simplex;
  simplex.step = options.first_step;
  double before = 0;
  std::vector<double> last(u.begin(), u.end());
  std::vector<double> progress(d, 0.0);
  bool exhausted = false;
  while (result.sweeps < options.max_sweeps && !exhausted) {
    for (std::size_t s = 0; s < stages; ++s) {
      const std::size_t begin = d * s / stages;
      const std::size_t end = d * (s + 1) / stages;
      const std::size_t left = options.max_evaluations - result.evaluations;
      exhausted = left < end - begin + 1;
      if (exhausted) break;
      // A stage is one of many: it need not be exact, only better. The whole is searched to the end.
      simplex.value_tolerance = stages == 1 ? options.gain_tolerance * 0.1 : options.gain_tolerance;
      simplex.size_tolerance = simplex.step * (stages == 1 ? 0.002 : 0.05);
      simplex.max_evaluations = std::min(left, 400 * (end - begin + 1));
      result.value = search(objective, std::span(order).subspan(begin, end - begin), simplex, u, work, result);
    }
    ++result.sweeps;
    const bool gained = result.sweeps == 1 || before - result.value > options.gain_tolerance * std::abs(result.value);
    before = result.value;
    if (!gained && (stages == 1 || simplex.step <= 0.03)) break;
    // Variables that still move are searched together next time: they are the ones that depend on each other.
    double moved = 0;
    for (std::size_t i = 0; i < d; ++i) {
      progress[i] = 0.5 * progress[i] + std::abs(u[i] - last[i]);
      moved = std::max(moved, std::abs(u[i] - last[i]));
      last[i] = u[i];
    }
    if (stages > 1) {
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return progress[a] > progress[b]; });
      simplex.step = std::clamp(moved, 0.02, std::max(0.02, simplex.step * 0.7));
    } else {
      simplex.step = std::max(0.02, simplex.step * 0.5);
    }
  }
  return result;
}

}  // namespace penpose::posing
