#include "core/portrait/features/smooth_path.h"

#include <algorithm>

namespace penpose::portrait {

std::vector<std::size_t> smooth_path(const std::vector<std::vector<double>>& scores, int jump, double rough) {
  const auto places = static_cast<int>(scores.front().size());
  std::vector<std::vector<double>> sums(scores.size(), std::vector<double>(scores.front().size(), -1e300));
  std::vector<std::vector<int>> from(scores.size(), std::vector<int>(scores.front().size(), 0));
  sums[0] = scores[0];
  for (std::size_t i = 1; i < scores.size(); ++i) {
    for (int s = 0; s < places; ++s) {
      for (int d = -jump; d <= jump; ++d) {
        if (s + d < 0 || s + d >= places) continue;
        const double sum = sums[i - 1][s + d] + scores[i][s] - rough * d * d;
        if (sum > sums[i][s]) {
          sums[i][s] = sum;
          from[i][s] = s + d;
        }
      }
    }
  }
  std::vector<std::size_t> path(scores.size());
  auto at = std::max_element(sums.back().begin(), sums.back().end()) - sums.back().begin();
  for (std::size_t i = scores.size(); i-- > 0;) {
    path[i] = static_cast<std::size_t>(at);
    at = from[i][at];
  }
  return path;
}

}  // namespace penpose::portrait
