#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"

// Commands of parameters.

namespace penpose::document {

/// Sets parameters. Errors: no such parameter, a value out of range.
struct SetParameters {
  static constexpr Called k_called{"set_parameters", "Set a control"};
  std::vector<NamedValue> values;
  static auto members(auto& self) { return base::named("values", self.values); }
};
Changed run(const Document&, const SetParameters&, ApplyParts&);

/// Puts parameters at rest; all of them when no name is given.
struct ResetParameters {
  static constexpr Called k_called{"reset_parameters", "Back to rest"};
  std::vector<std::string> names;
  static auto members(auto& self) { return base::named("names", self.names); }
};
Changed run(const Document&, const ResetParameters&, ApplyParts&);

/// Locks parameters against the solver, or frees them.
struct LockParameters {
  static constexpr Called k_called{"lock_parameters", "Lock or unlock"};
  std::vector<std::string> names;
  bool locked = true;
  static auto members(auto& self) { return base::named("names", self.names, "locked", self.locked); }
};
Changed run(const Document&, const LockParameters&, ApplyParts&);

/// Moves every control that is neither held nor locked towards the values that the keyed poses suggest (core/prior).
/// Errors: no such parameter, nothing held, a strength out of 0..1, fewer than two different keys, held parameters that
/// no key moves.
struct SuggestRest {
  static constexpr Called k_called{"suggest_rest", "Take the suggestion"};
  std::vector<std::string> held;
  double strength = 1;  ///< 0..1: how much of the way
  static auto members(auto& self) { return base::named("held", self.held, "strength", self.strength); }
};
Changed run(const Document&, const SuggestRest&, ApplyParts&);

using ParameterCommands = std::variant<SetParameters, ResetParameters, LockParameters, SuggestRest>;

}  // namespace penpose::document
