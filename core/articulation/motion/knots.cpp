#include "core/articulation/motion/knots.h"

#include <algorithm>

namespace penpose::articulation {

double Knot::weight(double at) const {
  const bool open_below = below == amount;
  const bool open_above = above == amount;
  const bool by_below = (at < amount || open_above) && !open_below;
  const double from = by_below ? below : above;
  return std::max(0.0, (at - from) / (amount - from));
}

std::vector<Knot> knots_of(std::span<const double> amounts) {
  std::vector<double> all(amounts.begin(), amounts.end());
  all.push_back(0.0);
  all.push_back(1.0);
  std::stable_sort(all.begin(), all.end());
  std::vector<Knot> knots;
  for (const double amount : amounts) {
    const auto at = std::find(all.begin(), all.end(), amount);
    knots.push_back({amount, at == all.begin() ? amount : *(at - 1), at + 1 == all.end() ? amount : *(at + 1)});
  }
  return knots;
}

}  // namespace penpose::articulation
