#include "core/intent/choosing/selection.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/cholesky.h"
#include "core/base/math.h"

namespace penpose::intent {

double Selection::units_near_limit(const Choice& choice) const {
  double sum = 0;
  for (const std::size_t u : choice.units) {
    const Unit& unit = choices_.units[u];
    double most = 0;
    for (std::size_t m = 0; m < unit.count; ++m)
      most = std::max(most, share_of_range(value_of(choice, unit.members[m]), unit.members[m], choices_));
    sum += std::max(0.0, (most - costs_.limit_from) / (1.0 - costs_.limit_from));
  }
  return sum;
}

double Selection::limit_costs(const Choice& choice) const { return costs_.limit * units_near_limit(choice); }

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

bool Selection::overlaps(const Choice& choice, std::size_t unit) const {
  return std::any_of(choice.units.begin(), choice.units.end(), [&](std::size_t one) { return overlaps(one, unit); });
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
  return costs_.unit + costs_.evidence * base::log(1.0 + std::max(0.0, curvature)) +
         costs_.movement * base::log(1.0 + way / costs_.usual_way) + unit.charge;
}

double Selection::costs_of(const Choice& choice) const {
  double sum = 0;
  for (const std::size_t u : choice.units) {
    const Unit& unit = choices_.units[u];
    sum += unit_cost(unit, choice);
    if (!unit.tied) continue;
    const double apart = value_of(choice, unit.members[0]) - value_of(choice, unit.members[1]);
    sum += costs_.tie * apart * apart;
  }
  return sum;
}

void Selection::set_up(const Choice& choice) {
  const std::size_t n = choice.variables.size();
  matrix_.resize(n * n);
  pulls_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t v = choice.variables[i];
    pulls_[i] = q_.pull(v);
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
}

Choice Selection::fit(std::vector<std::size_t> units) {
  ++evaluations_;
  Choice choice = choice_of_units(choices_, std::move(units));
  set_up(choice);
  choice.values = squares_.solve(matrix_, pulls_, choice.variables, choices_);
  const std::size_t n = choice.variables.size();
  double energy = q_.constant();
  for (std::size_t i = 0; i < n; ++i) {
    double image = 0;
    for (std::size_t k = 0; k < n; ++k)
      image += q_.curvature(choice.variables[i], choice.variables[k]) * choice.values[k];
    image += choices_.stiffness[choice.variables[i]] * choice.values[i];
    energy += choice.values[i] * (image - 2.0 * pulls_[i]);
  }
  choice.costs = costs_of(choice);
  choice.costs += limit_costs(choice);
  choice.energy = energy + choice.costs;
  return choice;
}

Selection::Base Selection::base_of(Choice choice) {
  for (const std::size_t v : choice.variables) q_.prepare(v);
  set_up(choice);
  Base base{std::move(choice), matrix_};
  if (!algebra::factor(base.factor.data(), base.choice.variables.size(), k_least_pivot)) base.factor.clear();
  return base;
}

double Selection::least_with(const Base& base, std::size_t added) {
  const Unit& unit = choices_.units[added];
  const std::size_t n = base.choice.variables.size();
  double least = base.choice.energy + costs_.unit + unit.charge;
  double curvature = 0;
  for (std::size_t m = 0; m < unit.count; ++m) curvature = std::max(curvature, q_.curvature(unit.members[m]));
  least += costs_.evidence * base::log(1.0 + std::max(0.0, curvature));
  if (base.factor.empty() && n > 0) return -1e300;
  // The descent along each member, and the curvature that is left of it when the base gives way (Schur complement).
  // What members gain together is at most the sum over them for each left to itself times their number.
  double gain = 0;
  for (std::size_t m = 0; m < unit.count; ++m) {
    const std::size_t v = unit.members[m];
    double pull = q_.pull(v);
    solved_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double c = q_.curvature(base.choice.variables[i], v);
      pull -= c * base.choice.values[i];
      solved_[i] = c;
    }
    double left = q_.curvature(v) + choices_.stiffness[v];
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) solved_[i] -= base.factor[i * n + k] * solved_[k];
      solved_[i] /= base.factor[i * n + i];
      left -= solved_[i] * solved_[i];
    }
    if (left > 1e-9 * q_.curvature(v)) gain += pull * pull / left;
  }
  return least - gain * static_cast<double>(unit.count == 1 ? 1 : 2);
}

double Selection::worth(const Choice& choice) const {
  return something_ && choice.units.empty() ? 1e300 : choice.energy;
}

void Selection::consider(std::vector<std::size_t> units, Choice& best) {
  Choice tried = fit(std::move(units));
  if (rival_count_ > 0) rivals_.push_back(tried);
  if (tried.energy < worth(best) - 1e-9) best = std::move(tried);
}

void Selection::try_all(const Base& base, Choice& best, std::size_t most) {
  if (base.choice.units.size() >= most) return;
  for (std::size_t u = 0; u < choices_.units.size(); ++u) {
    if (overlaps(base.choice, u)) continue;
    if (least_with(base, u) > worth(best) + rival_window_) continue;
    auto units = base.choice.units;
    units.insert(std::lower_bound(units.begin(), units.end(), u), u);
    consider(std::move(units), best);
  }
}

Choice Selection::select(Choice first, std::size_t most) {
  Choice current = std::move(first);
  constexpr int k_rounds = 40;
  for (int round = 0; round < k_rounds; ++round) {
    rivals_.clear();
    Choice best = current;
    try_all(base_of(current), best, most);
    for (const std::size_t out : current.units) {
      auto fewer = current.units;
      std::erase(fewer, out);
      Choice without = fit(std::move(fewer));
      if (rival_count_ > 0) rivals_.push_back(without);
      if (worth(without) < worth(best) - 1e-9) best = without;
      try_all(base_of(std::move(without)), best, most);
    }
    if (!(worth(best) < worth(current) - 1e-9)) break;
    current = std::move(best);
  }
  std::erase_if(rivals_, [&](const Choice& one) {
    return one.energy > current.energy + rival_window_ || one.units == current.units;
  });
  std::stable_sort(rivals_.begin(), rivals_.end(),
                   [](const Choice& a, const Choice& b) { return a.energy < b.energy; });
  if (rivals_.size() > rival_count_) rivals_.resize(rival_count_);
  return current;
}

}  // namespace penpose::intent
