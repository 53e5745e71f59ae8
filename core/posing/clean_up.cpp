#include "core/posing/clean_up.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace penpose::posing {

std::size_t clean_up(Revertible& solution, double limit) {
  struct Candidate {
    double energy;
    std::size_t index;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < solution.count(); ++i) {
    if (!solution.changed(i)) continue;
    const double energy = solution.energy_without(i);
    if (energy <= limit) candidates.push_back({energy, i});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.energy, a.index) < std::tie(b.energy, b.index);
  });
  std::size_t put_back = 0;
  for (const Candidate& candidate : candidates) {
    if (put_back > 0 && solution.energy_without(candidate.index) > limit) continue;
    solution.put_back(candidate.index);
    ++put_back;
  }
  return put_back;
}

}  // namespace penpose::posing
