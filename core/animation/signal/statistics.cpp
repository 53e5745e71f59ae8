#include "core/animation/signal/statistics.h"

#include <algorithm>
#include <cmath>

namespace penpose::animation {

double quantile(std::span<const double> numbers, double share) {
  if (numbers.empty()) return 0;
  std::vector<double> sorted(numbers.begin(), numbers.end());
  std::stable_sort(sorted.begin(), sorted.end());
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const double part = at - static_cast<double>(below);
  return below + 1 < sorted.size() ? sorted[below] * (1 - part) + sorted[below + 1] * part : sorted[below];
}

double spread(std::span<const double> numbers) {
  const double middle = quantile(numbers, 0.5);
  std::vector<double> apart;
  for (const double number : numbers) apart.push_back(std::abs(number - middle));
  constexpr double k_normal = 1.4826;
  return k_normal * quantile(apart, 0.5);
}

std::vector<double> running_median(std::span<const double> numbers, std::size_t half) {
  std::vector<double> result;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t first = i < half ? 0 : i - half;
    const std::size_t last = std::min(i + half + 1, numbers.size());
    result.push_back(quantile(numbers.subspan(first, last - first), 0.5));
  }
  return result;
}

}  // namespace penpose::animation
