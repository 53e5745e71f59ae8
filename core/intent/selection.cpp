#include "core/intent/selection.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::intent {
namespace {

/// A choice without the units that overlap `unit`, plus it, in ascending order.
std::vector<std::size_t> with(const std::vector<std::size_t>& units, std::size_t unit, auto&& keep) {
  std::vector<std::size_t> out;
  for (const std::size_t one : units) {
    if (keep(one)) out.push_back(one);
  }
  out.insert(std::lower_bound(out.begin(), out.end(), unit), unit);
  return out;
}

}  // namespace

bool Selection::overlaps(std::size_t a, std::size_t b) const {
  const Unit& one = choices_.units[a];
  const Unit& other = choices_.units[b];
  for (std::size_t i = 0; i < one.count; ++i) {
    for (std::size_t k = 0; k < other.count; ++k) {
      if (one.members[i] == other.members[k]) return true;
    }
  }
  return false;
}

double Selection::value_of(const Choice& choice, std::size_t variable) const {
  const auto at = std::lower_bound(choice.variables.begin(), choice.variables.end(), variable);
  return choice.values[static_cast<std::size_t>(at - choice.variables.begin())];
}

double Selection::unit_cost(const Unit& unit, const Choice& choice) const {
  double curvature = 0;
  double way = 0;
  for (std::size_t m = 0; m < unit.count; ++m) {
    curvature = std::max(curvature, q_.curvature(unit.members[m]));
    way += std::abs(value_of(choice, unit.members[m])) * choices_.movement[unit.members[m]];
  }
  if (unit.tied) way /= static_cast<double>(unit.count);
  return costs_.unit + (unit.tied ? costs_.pair : 0.0) + costs_.evidence * base::log(1.0 + std::max(0.0, curvature)) +
         costs_.movement * base::log(1.0 + way / costs_.usual_way);
}

double Selection::costs_of(const Choice& choice) const {
  double sum = 0;
  for (const std::size_t u : choice.units) sum += unit_cost(choices_.units[u], choice);
  return sum;
}

Choice Selection::fit(std::vector<std::size_t> units) {
  ++evaluations_;
  Choice choice;
  choice.units = std::move(units);
  for (const std::size_t u : choice.units) {
    const Unit& unit = choices_.units[u];
    choice.variables.insert(choice.variables.end(), unit.members.begin(), unit.members.begin() + unit.count);
  }
  std::sort(choice.variables.begin(), choice.variables.end());
  const std::size_t n = choice.variables.size();
  choice.values.assign(n, 0.0);
  matrix_.assign(n * n, 0.0);
  descent_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t v = choice.variables[i];
    descent_[i] = q_.pull(v);
    for (std::size_t k = 0; k < i; ++k) matrix_[i * n + k] = matrix_[k * n + i] = q_.curvature(choice.variables[k], v);
    matrix_[i * n + i] = q_.curvature(v) + choices_.stiffness[v];
  }
  const auto place = [&](std::size_t variable) {
    return static_cast<std::size_t>(std::lower_bound(choice.variables.begin(), choice.variables.end(), variable) -
                                    choice.variables.begin());
  };
  for (const std::size_t u : choice.units) {
    const Unit& unit = choices_.units[u];
    if (!unit.tied) continue;
    const std::size_t a = place(unit.members[0]);
    const std::size_t b = place(unit.members[1]);
    matrix_[a * n + a] += costs_.tie;
    matrix_[b * n + b] += costs_.tie;
    matrix_[a * n + b] -= costs_.tie;
    matrix_[b * n + a] -= costs_.tie;
  }
  constexpr int k_sweeps = 200;
  for (int sweep = 0; sweep < k_sweeps; ++sweep) {
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!(matrix_[i * n + i] > 0.0)) continue;
      const std::size_t v = choice.variables[i];
      const double to =
          std::clamp(choice.values[i] + descent_[i] / matrix_[i * n + i], choices_.low[v], choices_.high[v]);
      const double change = to - choice.values[i];
      if (change == 0.0) continue;
      choice.values[i] = to;
      for (std::size_t k = 0; k < n; ++k) descent_[k] -= change * matrix_[i * n + k];
      largest = std::max(largest, std::abs(change));
    }
    if (largest < 1e-6) break;
  }
  // E = constant - 2 z'pull + z'Mz, and what is left of the descent is pull - Mz.
  double energy = q_.constant();
  for (std::size_t i = 0; i < n; ++i) energy -= choice.values[i] * (q_.pull(choice.variables[i]) + descent_[i]);
  choice.costs = costs_of(choice);
  choice.energy = energy + choice.costs;
  return choice;
}

void Selection::consider(std::vector<std::size_t> units, Choice& best) {
  Choice tried = fit(std::move(units));
  if (rival_count_ > 0) rivals_.push_back(tried);
  if (tried.energy < best.energy - 1e-9) best = std::move(tried);
}

Choice Selection::select(Choice first, std::size_t most) {
  Choice current = std::move(first);
  constexpr int k_rounds = 40;
  for (int round = 0; round < k_rounds; ++round) {
    rivals_.clear();
    Choice best = current;
    for (std::size_t u = 0; u < choices_.units.size(); ++u) {
      if (std::binary_search(current.units.begin(), current.units.end(), u)) continue;
      const auto apart = [&](std::size_t one) { return !overlaps(one, u); };
      auto added = with(current.units, u, apart);
      if (added.size() <= most) consider(added, best);
      for (const std::size_t out : current.units) {
        if (!apart(out)) continue;
        consider(with(current.units, u, [&](std::size_t one) { return one != out && apart(one); }), best);
      }
    }
    for (const std::size_t out : current.units) {
      auto fewer = current.units;
      std::erase(fewer, out);
      consider(std::move(fewer), best);
    }
    if (!(best.energy < current.energy - 1e-9)) break;
    current = std::move(best);
  }
  std::stable_sort(rivals_.begin(), rivals_.end(),
                   [](const Choice& a, const Choice& b) { return a.energy < b.energy; });
  std::erase_if(rivals_, [&](const Choice& one) { return one.energy > current.energy + rival_window_; });
  if (rivals_.size() > rival_count_) rivals_.resize(rival_count_);
  return current;
}

}  // namespace penpose::intent
