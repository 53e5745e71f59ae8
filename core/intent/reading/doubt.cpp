#include "core/intent/reading/doubt.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::intent {

std::size_t Doubt::add_group(double reach) {
  groups_.push_back({0, reach});
  return groups_.size() - 1;
}

void Doubt::add_curve(std::size_t group) {
  group_of_.push_back(group);
  groups_[group].count += 1.0;
}

void Doubt::measure(std::span<const double> squares) const {
  sums_.assign(groups_.size(), 0.0);
  for (std::size_t c = 0; c < group_of_.size(); ++c) sums_[group_of_[c]] += std::max(0.0, squares[c]);
  for (std::size_t g = 0; g < groups_.size(); ++g) sums_[g] /= groups_[g].reach * groups_[g].count;
}

double Doubt::energy(std::span<const double> squares) const {
  measure(squares);
  double sum = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    sum += groups_[g].reach * std::sqrt(groups_[g].count) * base::log(1.0 + sums_[g]);
  for (std::size_t c = group_of_.size(); c < squares.size(); ++c) sum += squares[c];
  return sum;
}

double Doubt::added_by(std::size_t curve, std::span<const double> squares) const {
  const Group& group = groups_[group_of_[curve]];
  double sum = 0;
  double others = 0;
  for (std::size_t c = 0; c < squares.size(); ++c) {
    if (group_of_[c] != group_of_[curve]) continue;
    sum += std::max(0.0, squares[c]);
    if (c != curve) others += std::max(0.0, squares[c]);
  }
  const double scale = group.reach * group.count;
  return group.reach * std::sqrt(group.count) * (base::log(1.0 + sum / scale) - base::log(1.0 + others / scale));
}

void Doubt::weights(std::span<const double> squares, std::vector<double>& out) const {
  measure(squares);
  out.assign(squares.size(), 1.0);
  for (std::size_t c = 0; c < group_of_.size(); ++c) {
    const std::size_t g = group_of_[c];
    out[c] = 1.0 / (std::sqrt(groups_[g].count) * (1.0 + sums_[g]));
  }
}

}  // namespace penpose::intent
