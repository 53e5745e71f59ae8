#include "core/posing/clean_up.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace penpose::posing {

std::size_t clean_up(const std::function<double(std::span<const double>)>& energy, std::span<const double> before,
                     double limit, std::span<double> after) {
  struct Candidate {
    double energy;
    std::size_t index;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (after[i] == before[i]) continue;
    const double kept = after[i];
    after[i] = before[i];
    candidates.push_back({energy(after), i});
    after[i] = kept;
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.energy, a.index) < std::tie(b.energy, b.index);
  });
  std::size_t put_back = 0;
  for (const Candidate& candidate : candidates) {
    if (candidate.energy > limit) break;
    const double kept = after[candidate.index];
    after[candidate.index] = before[candidate.index];
    if (energy(after) <= limit) {
      ++put_back;
    } else {
      after[candidate.index] = kept;
    }
  }
  return put_back;
}

}  // namespace penpose::posing
