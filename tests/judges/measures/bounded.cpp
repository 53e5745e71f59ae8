#include "tests/judges/measures/bounded.h"

#include <algorithm>
#include <cmath>

namespace penpose::judges {

std::vector<double> bounded_least_squares(const std::vector<std::vector<double>>& columns, const std::vector<double>& b,
                                          double damp) {
  constexpr int k_most_rounds = 20000;
  constexpr double k_still = 1e-10;
  std::vector<double> x(columns.size(), 0);
  std::vector<double> left = b;
  std::vector<double> squares;
  for (const auto& column : columns) {
    double sum = damp * damp;
    for (const double a : column) sum += a * a;
    squares.push_back(sum);
  }
  for (int round = 0; round < k_most_rounds; ++round) {
    double farthest = 0;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      double slope = -damp * damp * x[j];
      for (std::size_t i = 0; i < left.size(); ++i) slope += columns[j][i] * left[i];
      const double next = std::clamp(x[j] + slope / squares[j], 0.0, 1.0);
      const double step = next - x[j];
      if (step == 0) continue;
      for (std::size_t i = 0; i < left.size(); ++i) left[i] -= columns[j][i] * step;
      x[j] = next;
      farthest = std::max(farthest, std::abs(step));
    }
    if (farthest < k_still) break;
  }
  return x;
}

}  // namespace penpose::judges
