#include "core/intent/choosing/robust_selection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/algebra/cholesky.h"
#include "core/algebra/vectors.h"
#include "core/base/math.h"

namespace penpose::intent {
namespace {

/// Times that curves are weighted anew for one choice; fewer where values change by less than this.
constexpr int k_weighings = 4;
constexpr double k_settled = 1e-3;
/// Of all units that might be added, so many are fitted: the best by a guess.
constexpr std::size_t k_tries = 10;

std::size_t index_in(std::span<const std::size_t> variables, std::size_t v) {
  return static_cast<std::size_t>(std::lower_bound(variables.begin(), variables.end(), v) - variables.begin());
}

}  // namespace

void RobustSelection::squares_at(const Choice& choice, std::vector<double>& out) const {
  const std::size_t n = choice.variables.size();
  out.resize(q_.part_count());
  const std::size_t parts = out.size();
  for (std::size_t p = 0; p < parts; ++p) out[p] = q_.part_constant(p);
  for (std::size_t i = 0; i < n; ++i) {
    if (choice.values[i] == 0.0) continue;
    const double* pulls = q_.part_pulls(choice.variables[i]);
    for (std::size_t p = 0; p < parts; ++p) out[p] -= 2.0 * choice.values[i] * pulls[p];
    for (std::size_t k = 0; k <= i; ++k) {
      const double by = (k == i ? 1.0 : 2.0) * choice.values[i] * choice.values[k];
      const double* curvatures = q_.part_curvatures(choice.variables[i], choice.variables[k]);
      for (std::size_t p = 0; p < parts; ++p) out[p] += by * curvatures[p];
    }
  }
  for (double& squares : out) squares = std::max(0.0, squares);
}

void RobustSelection::set_up(const Choice& choice, std::span<const double> weights) {
  const std::size_t n = choice.variables.size();
  matrix_.assign(n * n, 0.0);
  pulls_.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    pulls_[i] = algebra::dot(weights.data(), q_.part_pulls(choice.variables[i]), weights.size());
    for (std::size_t k = 0; k <= i; ++k)
      matrix_[i * n + k] =
          algebra::dot(weights.data(), q_.part_curvatures(choice.variables[i], choice.variables[k]), weights.size());
  }
  for (std::size_t i = 0; i < n; ++i) matrix_[i * n + i] += choices_.stiffness[choice.variables[i]];
  const double tie = costs_.weights().by[inference::Term::tie];
  for (const std::size_t u : choice.units) {
    const Unit& unit = choices_.units[u];
    if (!unit.tied) continue;
    const std::size_t a = index_in(choice.variables, unit.members[0]);
    const std::size_t b = index_in(choice.variables, unit.members[1]);
    matrix_[a * n + a] += tie;
    matrix_[b * n + b] += tie;
    matrix_[std::max(a, b) * n + std::min(a, b)] -= tie;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) matrix_[k * n + i] = matrix_[i * n + k];
  }
}

Choice RobustSelection::fit(std::vector<std::size_t> units) {
  ++evaluations_;
  Choice choice = choice_of_units(choices_, std::move(units));
  for (const std::size_t v : choice.variables) q_.prepare_parts(v);
  const std::size_t n = choice.variables.size();
  choice.values.assign(n, 0.0);
  squares_at(choice, squares_);
  for (int weighing = 0; weighing < k_weighings && n > 0; ++weighing) {
    doubt_.weights(squares_, weights_);
    set_up(choice, weights_);
    std::vector<double> values = bounded_.solve(matrix_, pulls_, choice.variables, choices_);
    double change = 0;
    for (std::size_t i = 0; i < n; ++i) change = std::max(change, std::abs(values[i] - choice.values[i]));
    choice.values = std::move(values);
    squares_at(choice, squares_);
    if (weighing > 0 && change < k_settled) break;
  }
  choice.costs = costs_.costs_of(choice) + costs_.limit_costs(choice);
  choice.energy = doubt_.energy(squares_) + choice.costs + costs_.stiffness_of(choice);
  return choice;
}

RobustSelection::Base RobustSelection::base_of(const Choice& choice) {
  const std::size_t n = choice.variables.size();
  for (const std::size_t v : choice.variables) q_.prepare_parts(v);
  Base base;
  base.choice = &choice;
  squares_at(choice, base.squares);
  doubt_.weights(base.squares, base.weights);
  set_up(choice, base.weights);
  base.factor = matrix_;
  if (!algebra::factor(base.factor.data(), n, k_least_pivot)) base.factor.clear();
  const std::size_t parts = q_.part_count();
  for (std::size_t i = 0; i < n; ++i) {
    const double* pulls = q_.part_pulls(choice.variables[i]);
    base.pulls.insert(base.pulls.end(), pulls, pulls + parts);
    double* left = base.pulls.data() + i * parts;
    for (std::size_t k = 0; k < n; ++k) {
      const double* curvatures = q_.part_curvatures(choice.variables[i], choice.variables[k]);
      for (std::size_t p = 0; p < parts; ++p) left[p] -= curvatures[p] * choice.values[k];
    }
  }
  return base;
}

const std::vector<double>& RobustSelection::between(std::size_t u) {
  between_.resize(choices_.units.size());
  const Unit& unit = choices_.units[u];
  std::vector<double>& known = between_[u];
  if (!known.empty()) return known;
  for (std::size_t m = 0; m < unit.count; ++m) {
    for (std::size_t l = 0; l < m; ++l) {
      const std::vector<double> pair = q_.part_products_of(unit.members[l], unit.members[m]);
      known.insert(known.end(), pair.begin(), pair.end());
    }
  }
  return known;
}

RobustSelection::Direction RobustSelection::direction_of(const Base& base, std::size_t added,
                                                         const std::array<double, 3>& by) {
  const Unit& unit = choices_.units[added];
  const std::span<const std::size_t> variables = base.choice->variables;
  const std::size_t n = variables.size();
  const std::size_t parts = q_.part_count();
  Direction out{std::vector<double>(parts, 0.0), std::vector<double>(parts, 0.0), std::vector<double>(parts * n, 0.0)};
  for (std::size_t m = 0; m < unit.count; ++m) {
    const std::size_t v = unit.members[m];
    const double* own = q_.part_pulls(v);
    const double* diagonal = q_.part_curvatures(v, v);
    for (std::size_t p = 0; p < parts; ++p) {
      out.pull[p] += by[m] * own[p];
      out.curvature[p] += by[m] * by[m] * diagonal[p];
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double* with = q_.part_curvatures(variables[i], v);
      double* products = out.cross.data() + i * parts;
      for (std::size_t p = 0; p < parts; ++p) {
        out.pull[p] -= by[m] * with[p] * base.choice->values[i];
        products[p] += by[m] * with[p];
      }
    }
  }
  if (unit.count == 1) return out;
  const double* pair = between(added).data();
  for (std::size_t m = 0; m < unit.count; ++m) {
    for (std::size_t l = 0; l < m; ++l, pair += parts) {
      for (std::size_t p = 0; p < parts; ++p) out.curvature[p] += 2.0 * by[m] * by[l] * pair[p];
    }
  }
  return out;
}

std::vector<double> RobustSelection::answer_to(const Base& base, const std::vector<double>& cross) const {
  const std::size_t n = base.choice->variables.size();
  const std::size_t parts = q_.part_count();
  std::vector<double> answer(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) answer[i] = algebra::dot(base.weights.data(), cross.data() + i * parts, parts);
  return answer;
}

std::optional<double> RobustSelection::guess(const Base& base, std::size_t added) {
  const Unit& unit = choices_.units[added];
  if (unit.count > 1 && !unit.tied) return guess_several(base, added);
  const std::size_t n = base.choice->variables.size();
  // The unit as one direction.
  const Direction direction = direction_of(base, added, {1.0, 1.0, 1.0});
  std::vector<double> answer = answer_to(base, direction.cross);
  const std::size_t parts = q_.part_count();
  const double whole_pull = algebra::dot(base.weights.data(), direction.pull.data(), parts);
  double left = algebra::dot(base.weights.data(), direction.curvature.data(), parts);
  const double whole = left;
  if (!base.factor.empty()) {
    const std::vector<double> products = answer;
    algebra::solve_factored(base.factor.data(), n, answer.data());
    for (std::size_t i = 0; i < n; ++i) left -= products[i] * answer[i];
  }
  if (!(left > 1e-9 * whole)) return std::nullopt;
  const std::size_t v = unit.members[0];
  const double stiffness = choices_.stiffness[v] * static_cast<double>(unit.count);
  const double step = std::clamp(whole_pull / (left + stiffness), choices_.low[v], choices_.high[v]);
  if (step == 0.0) return std::nullopt;
  return energy_along(base, direction, answer, step) + stiffness * step * step;
}

std::optional<double> RobustSelection::guess_several(const Base& base, std::size_t added) {
  const Unit& unit = choices_.units[added];
  const std::size_t n = base.choice->variables.size();
  const std::size_t count = unit.count;
  const std::size_t parts = q_.part_count();
  // Solve for each member alone, while the base gives way to it.
  std::vector<double> matrix(count * count, 0.0), pulls(count, 0.0);
  std::array<std::vector<double>, 3> products;
  const double* pair = between(added).data();
  for (std::size_t m = 0; m < count; ++m) {
    std::array<double, 3> alone{};
    alone[m] = 1.0;
    const Direction one = direction_of(base, added, alone);
    products[m] = answer_to(base, one.cross);
    std::vector<double> answer = products[m];
    if (!base.factor.empty()) algebra::solve_factored(base.factor.data(), n, answer.data());
    const auto given_way = [&](const std::vector<double>& of) {
      return base.factor.empty() ? 0.0 : algebra::dot(of.data(), answer.data(), n);
    };
    pulls[m] = algebra::dot(base.weights.data(), one.pull.data(), parts);
    matrix[m * count + m] = algebra::dot(base.weights.data(), one.curvature.data(), parts) - given_way(products[m]) +
                            choices_.stiffness[unit.members[m]];
    for (std::size_t l = 0; l < m; ++l, pair += parts) {
      matrix[m * count + l] = algebra::dot(base.weights.data(), pair, parts) - given_way(products[l]);
      matrix[l * count + m] = matrix[m * count + l];
    }
  }
  const std::vector<double> by = bounded_.solve(matrix, pulls, std::span(unit.members).first(count), choices_);
  std::array<double, 3> turn{};
  std::copy(by.begin(), by.end(), turn.begin());
  double stiffness = 0;
  for (std::size_t m = 0; m < count; ++m) stiffness += choices_.stiffness[unit.members[m]] * turn[m] * turn[m];
  if (stiffness == 0.0 && turn == std::array<double, 3>{}) return std::nullopt;
  const Direction direction = direction_of(base, added, turn);
  std::vector<double> answer = answer_to(base, direction.cross);
  if (!base.factor.empty()) algebra::solve_factored(base.factor.data(), n, answer.data());
  return energy_along(base, direction, answer, 1.0) + stiffness;
}

double RobustSelection::energy_along(const Base& base, const Direction& direction, std::span<const double> answer,
                                     double step) const {
  const std::span<const std::size_t> variables = base.choice->variables;
  const std::size_t n = variables.size();
  const std::size_t parts = q_.part_count();
  std::vector<double> squares = base.squares;
  std::vector<double> pull = direction.pull;
  std::vector<double> curvature = direction.curvature;
  for (std::size_t i = 0; i < n; ++i) {
    const double* pulls = base.pulls.data() + i * parts;
    const double* products = direction.cross.data() + i * parts;
    for (std::size_t p = 0; p < parts; ++p) {
      pull[p] -= answer[i] * pulls[p];
      curvature[p] -= 2.0 * answer[i] * products[p];
    }
    for (std::size_t k = 0; k <= i; ++k) {
      const double with = (k == i ? 1.0 : 2.0) * answer[i] * answer[k];
      const double* curvatures = q_.part_curvatures(variables[i], variables[k]);
      for (std::size_t p = 0; p < parts; ++p) curvature[p] += with * curvatures[p];
    }
  }
  for (std::size_t p = 0; p < parts; ++p) squares[p] -= step * (2.0 * pull[p] - step * curvature[p]);
  return doubt_.energy(squares) + base.choice->costs;
}

std::vector<std::size_t> RobustSelection::units_to_try(const Choice& from) {
  const Base base = base_of(from);
  const auto excluded = [&](std::size_t u) {
    return std::any_of(from.units.begin(), from.units.end(), [&](std::size_t one) { return costs_.excludes(one, u); });
  };
  std::vector<std::size_t> tries;
  std::vector<std::pair<double, std::size_t>> guesses;
  for (std::size_t u = 0; u < choices_.units.size(); ++u) {
    if (const auto energy = guess(base, u)) guesses.emplace_back(*energy + costs_.least_cost_beside(from, u), u);
  }
  std::stable_sort(guesses.begin(), guesses.end());
  // How units stand to each other is asked of those alone that may be among the best.
  std::vector<std::pair<double, std::size_t>> best;
  for (const auto& [least, u] : guesses) {
    if (best.size() == k_tries && least > best.back().first) break;
    if (excluded(u)) continue;
    const std::pair<double, std::size_t> one{least + costs_.cost_of_relations(from.units, u), u};
    best.insert(std::upper_bound(best.begin(), best.end(), one), one);
    if (best.size() > k_tries) best.pop_back();
  }
  for (const auto& [energy, u] : best) tries.push_back(u);
  return tries;
}

void RobustSelection::try_all(const Choice& from, Choice& best, std::size_t most) {
  if (from.units.size() >= most) return;
  for (const std::size_t u : units_to_try(from)) {
    auto units = from.units;
    units.insert(std::lower_bound(units.begin(), units.end(), u), u);
    Choice tried = fit(std::move(units));
    tried_.push_back(tried);
    if (tried.energy < best.energy - 1e-9) best = std::move(tried);
  }
}

Choice RobustSelection::select(Choice first, std::size_t most) {
  tried_.assign(1, first);
  const bool from_nothing = first.units.empty();
  Choice found = climb(std::move(first), most);
  if (!from_nothing) return found;
  // The first step may lead away from what two steps would find: a sum of shapes from its parts.
  const auto other = best_beside(found);
  if (!other) return found;
  Choice second = climb(*other, most);
  return second.energy < found.energy - 1e-9 ? second : found;
}

Choice RobustSelection::extend(Choice current, std::size_t most) {
  for (bool better = true; better;) {
    Choice best = current;
    try_all(current, best, most);
    better = best.energy < current.energy - 1e-9;
    current = std::move(best);
  }
  return current;
}

std::optional<Choice> RobustSelection::best_beside(const Choice& found) const {
  const Choice* best = nullptr;
  for (const Choice& one : tried_) {
    if (one.units.size() != 1 || (best != nullptr && best->energy <= one.energy)) continue;
    const bool held = std::any_of(found.units.begin(), found.units.end(),
                                  [&](std::size_t u) { return costs_.excludes(u, one.units.front()); });
    if (!held) best = &one;
  }
  return best == nullptr ? std::nullopt : std::optional<Choice>(*best);
}

Choice RobustSelection::climb(Choice current, std::size_t most) {
  constexpr int k_rounds = 12;
  for (int round = 0; round < k_rounds; ++round) {
    Choice best = current;
    try_all(current, best, most);
    for (const std::size_t out : current.units) {
      auto fewer = current.units;
      std::erase(fewer, out);
      const Choice without = fit(std::move(fewer));
      tried_.push_back(without);
      if (without.energy < best.energy - 1e-9) best = without;
      try_all(without, best, most);
    }
    if (!(best.energy < current.energy - 1e-9)) break;
    current = std::move(best);
  }
  return current;
}

std::vector<Choice> RobustSelection::best(std::size_t count, double window) const {
  std::vector<std::size_t> order(tried_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return tried_[a].energy < tried_[b].energy; });
  std::vector<Choice> out;
  for (const std::size_t i : order) {
    const Choice& one = tried_[i];
    if (out.size() >= count || (!out.empty() && one.energy > out.front().energy + window)) break;
    if (std::any_of(out.begin(), out.end(), [&](const Choice& c) { return c.units == one.units; })) continue;
    out.push_back(one);
  }
  return out;
}

}  // namespace penpose::intent
