#pragma once

#include <cstddef>
#include <span>

namespace penpose::posing {

/// What a clean-up works on: a solution whose variables can go back to where they were, one at a time.
class Revertible {
 public:
  virtual ~Revertible() = default;
  Revertible() = default;
  Revertible(const Revertible&) = delete;
  Revertible& operator=(const Revertible&) = delete;

  [[nodiscard]] virtual std::size_t count() const = 0;
  /// True when variable i is not where it was before the solve.
  [[nodiscard]] virtual bool changed(std::size_t i) const = 0;
  /// The energy with variable i also put back.
  virtual double energy_without(std::size_t i) = 0;
  virtual void put_back(std::size_t i) = 0;
};

/// Puts variables back that the search changed without need (paper 3.1; method, section 2, "Clean-up"): those whose
/// return keeps the energy within `limit`, one at a time in order of least change, each re-checked with those before
/// it, so that together they cannot undo the solution. Returns how many went back.
std::size_t clean_up(Revertible& solution, double limit);

}  // namespace penpose::posing
