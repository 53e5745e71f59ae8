#include "core/document/commands/list/parameter_commands.h"

#include <algorithm>
#include <string>

#include "core/base/numbers.h"
#include "core/document/commands/apply_parts.h"
#include "core/document/suggestion.h"

namespace penpose::document {
base::Result<std::size_t> number_of(const Document& document, const std::string& name, const char* member) {
  const auto number = rig::find_parameter(document.model->rig->parameters(), name);
  if (!number)
    return base::Error{"the model has no parameter \"" + name + "\"", member, "look at the names in the model"};
  return *number;
}

base::Result<std::vector<std::size_t>> numbers_of(const Document& document, const std::vector<std::string>& names) {
  std::vector<std::size_t> numbers;
  for (const std::string& name : names) {
    const auto number = number_of(document, name, "names");
    if (!number) return number.error();
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<base::Error> out_of_range(const rig::Parameter& parameter, double value) {
  if (value >= parameter.minimum && value <= parameter.maximum) return std::nullopt;
  return base::Error{
      "\"" + parameter.name + "\" cannot be " + base::format_double(value), "values",
      "its range is " + base::format_double(parameter.minimum) + " to " + base::format_double(parameter.maximum)};
}

Changed run(const Document& document, const SetParameters& command, Parts&) {
  Document changed = document;
  const auto parameters = document.model->rig->parameters();
  for (const auto& [name, value] : command.values) {
    const auto number = number_of(document, name, "values");
    if (!number) return number.error();
    if (auto error = out_of_range(parameters[*number], value)) return *error;
    changed.pose[*number] = value;
  }
  return changed;
}

Changed run(const Document& document, const ResetParameters& command, Parts&) {
  const auto found = numbers_of(document, command.names);
  if (!found) return found.error();
  Document changed = document;
  const auto parameters = document.model->rig->parameters();
  for (const std::size_t number : *found) changed.pose[number] = parameters[number].rest;
  if (command.names.empty()) changed.pose = rig::rest_pose(*document.model->rig);
  return changed;
}

Changed run(const Document& document, const LockParameters& command, Parts&) {
  if (const auto found = numbers_of(document, command.names); !found) return found.error();
  Document changed = document;
  for (const std::string& name : command.names) {
    const auto place = std::lower_bound(changed.locked.begin(), changed.locked.end(), name);
    const bool there = place != changed.locked.end() && *place == name;
    if (command.locked && !there) changed.locked.insert(place, name);
    if (!command.locked && there) changed.locked.erase(place);
  }
  return changed;
}

Changed run(const Document& document, const SuggestRest& command, Parts&) {
  auto suggestion = suggest_rest(document, document.timeline->keys, command.held, command.strength);
  if (!suggestion) return suggestion.error();
  Document changed = document;
  changed.pose = std::move(suggestion->pose);
  return changed;
}

}  // namespace penpose::document
