#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/inference/terms.h"

namespace penpose::intent {

/// Share of a variable's own curvature that must be left of it beside those before it.
inline constexpr double k_least_pivot = 1e-12;

/// Controls that are chosen together: one parameter, a left and a right one, or the angles of one joint. `members` are
/// numbers of variables.
struct Unit {
  std::array<std::size_t, 3> members{};
  std::size_t count = 1;
  bool tied = false;         ///< left and right move alike
  double charge = 0;         ///< its own cost, added to the cost of every unit
  inference::Terms terms{};  ///< of lines on faces: what the charge is the weighted sum of
};

/// The variables of a choice: changes of parameters, each as a share of its range.
struct Choices {
  std::vector<Unit> units;
  std::vector<double> low, high;  ///< one a variable, low <= 0 <= high
  std::vector<double> movement;   ///< of the whole model, one a variable (WholeModel::movement)
  std::vector<double> stiffness;  ///< cost of the square of a variable; twists of joints cost more
};

/// Some units with their values: one reading of the strokes.
struct Choice {
  std::vector<std::size_t> units;      ///< numbers of units, ascending
  std::vector<std::size_t> variables;  ///< their members, ascending, without repeats
  std::vector<double> values;          ///< one a variable
  double energy = 0;                   ///< squares and costs
  double costs = 0;                    ///< of its units alone
};

/// How far a value is on its way to the end of its range, 0 to 1; 0 where it has none on that side.
[[nodiscard]] double share_of_range(double value, std::size_t variable, const Choices& choices);
/// A choice of these units, ascending, with their variables and without values.
[[nodiscard]] Choice choice_of_units(const Choices& choices, std::vector<std::size_t> units);

/// A choice whose `limited` variables change by no more than `most` from an earlier one.
[[nodiscard]] Choice trusted(const Choice& before, Choice after, double most,
                             const std::function<bool(std::size_t)>& limited);

/// What a choice costs.
class ChoiceCosts {
 public:
  virtual ~ChoiceCosts() = default;
  /// Of its units at its values, including the differences of pairs, without limit_costs.
  [[nodiscard]] virtual double costs_of(const Choice& choice) const = 0;
  /// The extra cost of units at an end of a range.
  [[nodiscard]] virtual double limit_costs(const Choice& choice) const = 0;
};

}  // namespace penpose::intent
