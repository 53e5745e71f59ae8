#include "core/intent/choosing/choice.h"

#include <algorithm>
#include <utility>

namespace penpose::intent {

double share_of_range(double value, std::size_t variable, const Choices& choices) {
  const double end = value < 0.0 ? choices.low[variable] : choices.high[variable];
  return end != 0.0 ? std::clamp(value / end, 0.0, 1.0) : value != 0.0 ? 1.0 : 0.0;
}

Choice choice_of_units(const Choices& choices, std::vector<std::size_t> units) {
  Choice choice;
  choice.units = std::move(units);
  for (const std::size_t u : choice.units) {
    const Unit& unit = choices.units[u];
    choice.variables.insert(choice.variables.end(), unit.members.begin(), unit.members.begin() + unit.count);
  }
  std::stable_sort(choice.variables.begin(), choice.variables.end());
  return choice;
}

Choice trusted(const Choice& before, Choice after, double most, const std::function<bool(std::size_t)>& limited) {
  for (std::size_t i = 0; i < after.variables.size(); ++i) {
    if (!limited(after.variables[i])) continue;
    const auto at = std::lower_bound(before.variables.begin(), before.variables.end(), after.variables[i]);
    const bool had = at != before.variables.end() && *at == after.variables[i];
    const double was = had ? before.values[static_cast<std::size_t>(at - before.variables.begin())] : 0.0;
    after.values[i] = std::clamp(after.values[i], was - most, was + most);
  }
  return after;
}

}  // namespace penpose::intent
