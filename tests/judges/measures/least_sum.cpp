#include "tests/judges/measures/least_sum.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::judges {

using geometry::ModelVector;

double least_sum_of_distances(const std::vector<std::vector<ModelVector>>& columns,
                              const std::vector<ModelVector>& goals) {
  constexpr int k_rounds = 400;
  constexpr int k_sweeps = 4;
  std::vector<double> x(columns.size(), 0);
  std::vector<ModelVector> left = goals;
  std::vector<double> weights(goals.size());
  double least = 1e300;
  double scale = 0;
  for (const ModelVector& goal : goals) scale = std::max(scale, geometry::length(goal));
  for (int round = 0; round < k_rounds; ++round) {
    double sum = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double distance = geometry::length(left[i]);
      sum += distance;
      weights[i] = 1 / std::max(distance, 1e-7 * scale);
    }
    least = std::min(least, sum);
    for (int sweep = 0; sweep < k_sweeps; ++sweep) {
      for (std::size_t j = 0; j < columns.size(); ++j) {
        double slope = 0;
        double square = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
          slope += weights[i] * glm::dot(columns[j][i], left[i]);
          square += weights[i] * glm::dot(columns[j][i], columns[j][i]);
        }
        if (square == 0) continue;
        const double step = std::clamp(x[j] + slope / square, 0.0, 1.0) - x[j];
        x[j] += step;
        for (std::size_t i = 0; i < left.size() && step != 0; ++i) left[i] -= columns[j][i] * step;
      }
    }
  }
  return least;
}

}  // namespace penpose::judges
