#include "core/intent/reading/reading_costs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/math.h"

namespace penpose::intent {

using inference::Term;

namespace {

/// Share of its range from which on a variable moves anything to speak of.
constexpr double k_moves = 0.005;

double value_of(const Choice& choice, std::size_t variable) {
  const auto at = std::lower_bound(choice.variables.begin(), choice.variables.end(), variable);
  return choice.values[static_cast<std::size_t>(at - choice.variables.begin())];
}

std::span<const std::size_t> members_of(const Unit& unit) { return {unit.members.data(), unit.count}; }

}  // namespace

double ReadingCosts::likeness(std::size_t a, std::size_t b) const {
  double most = 0;
  for (const std::size_t i : members_of(choices_.units[a])) {
    for (const std::size_t k : members_of(choices_.units[b])) {
      const double one = relations_.likeness(i, k);
      if (std::abs(one) > std::abs(most)) most = one;
    }
  }
  return most;
}

double ReadingCosts::overlap(std::size_t a, std::size_t b) const {
  double most = 0;
  for (const std::size_t i : members_of(choices_.units[a])) {
    for (const std::size_t k : members_of(choices_.units[b])) most = std::max(most, relations_.overlap(i, k));
  }
  return most;
}

bool ReadingCosts::excludes(std::size_t a, std::size_t b) const {
  for (const std::size_t i : members_of(choices_.units[a])) {
    for (const std::size_t k : members_of(choices_.units[b])) {
      if (i == k) return true;
    }
  }
  return likeness(a, b) > weights_.same;
}

double ReadingCosts::cost_of_relations(std::span<const std::size_t> units, std::size_t unit) const {
  double sum = 0;
  double helps = 0;
  for (const std::size_t other : units) {
    const double like = likeness(other, unit);
    sum += weights_.by[Term::against] * std::max(0.0, -like - 0.1);
    helps = std::max(helps, overlap(other, unit));
  }
  return sum + weights_.by[Term::helper] * helps;
}

void ReadingCosts::add_relations(std::span<const std::size_t> units, std::size_t unit, inference::Terms& terms) const {
  double helps = 0;
  for (const std::size_t other : units) {
    const double like = likeness(other, unit);
    terms[Term::against] += std::max(0.0, -like - 0.1);
    helps = std::max(helps, overlap(other, unit));
  }
  terms[Term::helper] += helps;
}

double ReadingCosts::least_cost_beside(const Choice& choice, std::size_t unit) const {
  double sum = choices_.units[unit].charge;
  for (std::size_t g = 0; g < asked_.size(); ++g) {
    const auto moves_it = [&](std::size_t u) { return moves(u, g); };
    if (moves_it(unit) && std::none_of(choice.units.begin(), choice.units.end(), moves_it)) sum -= cost_of_nothing(g);
  }
  return sum;
}

bool ReadingCosts::moves(std::size_t unit, std::size_t group) const {
  const auto members = members_of(choices_.units[unit]);
  return std::any_of(members.begin(), members.end(), [&](std::size_t v) { return relations_.moves_group(v, group); });
}

double ReadingCosts::decades_asked(std::size_t group) const {
  return base::log(std::max(1.0, asked_[group] / weights_.asks_from)) / base::log(10.0);
}

double ReadingCosts::cost_of_nothing(std::size_t group) const {
  return weights_.by[Term::nothing] * decades_asked(group);
}

double ReadingCosts::cost_of_nothing(std::span<const std::size_t> units) const {
  double sum = 0;
  for (std::size_t g = 0; g < asked_.size(); ++g) {
    if (std::none_of(units.begin(), units.end(), [&](std::size_t u) { return moves(u, g); })) sum += cost_of_nothing(g);
  }
  return sum;
}

std::vector<std::size_t> ReadingCosts::units_besides(std::vector<std::size_t> units, std::size_t group) const {
  std::erase_if(units, [&](std::size_t u) {
    for (std::size_t g = 0; g < asked_.size(); ++g) {
      if (g != group && moves(u, g)) return false;
    }
    return true;
  });
  return units;
}

double ReadingCosts::costs_for(const Choice& choice, std::size_t group) const {
  const auto without_nothing = [&](const Choice& one) { return costs_of(one) - cost_of_nothing(one.units); };
  Choice others = choice;
  others.units = units_besides(choice.units, group);
  const auto moves_it = [&](std::size_t u) { return moves(u, group); };
  const bool nothing = std::none_of(choice.units.begin(), choice.units.end(), moves_it);
  return without_nothing(choice) - without_nothing(others) + (nothing ? cost_of_nothing(group) : 0.0);
}

double ReadingCosts::stiffness_of(const Choice& choice) const {
  double sum = 0;
  for (std::size_t i = 0; i < choice.variables.size(); ++i)
    sum += choices_.stiffness[choice.variables[i]] * choice.values[i] * choice.values[i];
  return sum;
}

std::vector<std::size_t> ReadingCosts::moving(const Choice& choice) const {
  // What stays at nothing moves nothing.
  std::vector<std::size_t> moving;
  std::copy_if(choice.units.begin(), choice.units.end(), std::back_inserter(moving), [&](std::size_t u) {
    const auto members = members_of(choices_.units[u]);
    return std::any_of(members.begin(), members.end(),
                       [&](std::size_t v) { return std::abs(value_of(choice, v)) >= k_moves; });
  });
  return moving;
}

double ReadingCosts::costs_of(const Choice& choice) const {
  double sum = cost_of_nothing(moving(choice));
  for (std::size_t i = 0; i < choice.units.size(); ++i) {
    const Unit& unit = choices_.units[choice.units[i]];
    sum += unit.charge + cost_of_relations(std::span(choice.units).first(i), choice.units[i]);
    if (!unit.tied) continue;
    const double apart = value_of(choice, unit.members[0]) - value_of(choice, unit.members[1]);
    sum += weights_.by[Term::tie] * apart * apart;
  }
  return sum;
}

inference::Terms ReadingCosts::terms_of(const Choice& choice) const {
  inference::Terms terms;
  const std::vector<std::size_t> moves_something = moving(choice);
  for (std::size_t g = 0; g < asked_.size(); ++g) {
    if (std::none_of(moves_something.begin(), moves_something.end(), [&](std::size_t u) { return moves(u, g); }))
      terms[Term::nothing] += decades_asked(g);
  }
  for (std::size_t i = 0; i < choice.units.size(); ++i) {
    const Unit& unit = choices_.units[choice.units[i]];
    terms += unit.terms;
    add_relations(std::span(choice.units).first(i), choice.units[i], terms);
    if (!unit.tied) continue;
    const double apart = value_of(choice, unit.members[0]) - value_of(choice, unit.members[1]);
    terms[Term::tie] += apart * apart;
  }
  for (std::size_t i = 0; i < choice.variables.size(); ++i) {
    const double square = choice.values[i] * choice.values[i];
    if (relations_.is_joint(choice.variables[i])) {
      terms[Term::leaning] += choices_.stiffness[choice.variables[i]] * square;
    } else {
      terms[Term::share] += square;
    }
  }
  return terms;
}

}  // namespace penpose::intent
