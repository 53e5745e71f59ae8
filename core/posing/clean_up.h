#pragma once

#include <cstddef>
#include <span>

#include "core/base/interface.h"

namespace penpose::posing {

/// A solution whose variables can be reset to their values before the solve, one at a time.
class Revertible : public base::Interface {
 public:
  [[nodiscard]] virtual std::size_t count() const = 0;
  /// True when variable i differs from its value before the solve.
  [[nodiscard]] virtual bool changed(std::size_t i) const = 0;
  /// The energy with variable i also reset.
  virtual double energy_without(std::size_t i) = 0;
  virtual void put_back(std::size_t i) = 0;
};

/// Resets variables that the search changed without need (paper 3.1; method, section 2, "Clean-up"): those whose reset
/// keeps the energy within `limit`, one at a time in order of least change, each checked together with those before it,
/// so that they cannot undo the solution. Returns how many were reset.
std::size_t clean_up(Revertible& solution, double limit);

}  // namespace penpose::posing
