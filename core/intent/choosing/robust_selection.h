#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/intent/choosing/bounded_squares.h"
#include "core/intent/choosing/quadratic.h"
#include "core/intent/reading/doubt.h"
#include "core/intent/reading/reading_costs.h"

namespace penpose::intent {

/// Finds the best few choices of units for lines on faces: those of least Doubt::energy and ReadingCosts.
/// Deterministic: equal energies keep the choice that came first.
class RobustSelection {
 public:
  /// Precondition: the quadratic has a part for each curve, and one more for what counts by its squares.
  RobustSelection(Quadratic& quadratic, const ReadingCosts& costs, const Doubt& doubt)
      : q_(quadratic), choices_(costs.choices()), costs_(costs), doubt_(doubt) {}

  /// The least energy of these units: least squares within the ranges, weighted again and again by what is left.
  [[nodiscard]] Choice fit(std::vector<std::size_t> units);
  /// The best choice found from a first one, adding, exchanging and removing units; from nothing in two ways. `most`:
  /// units at most.
  [[nodiscard]] Choice select(Choice first, std::size_t most);
  /// The same, only adding.
  [[nodiscard]] Choice extend(Choice first, std::size_t most);
  /// The best of all that the last selection tried, each once, at most `window` above the first.
  [[nodiscard]] std::vector<Choice> best(std::size_t count, double window) const;
  /// The best single unit that the last selection tried; nothing where it tried none.
  [[nodiscard]] std::optional<Choice> best_of_one() const { return best_beside({}); }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

 private:
  /// A choice to add units to: its squares and their weights, and how it gives way to one more.
  struct Base {
    const Choice* choice = nullptr;
    std::vector<double> squares, weights;
    std::vector<double> factor;  ///< lower Cholesky factor of its weighted matrix, by rows
    std::vector<double> pulls;   ///< left of each variable, a run of parts a variable
  };
  void squares_at(const Choice& choice, std::vector<double>& out) const;
  /// Fills matrix_ and pulls_ for a choice's variables, the curves weighted.
  void set_up(const Choice& choice, std::span<const double> weights);
  [[nodiscard]] Base base_of(const Choice& choice);
  /// Describes a unit that moves along one line, its members in fixed shares. Holds the pull, the curvature and the
  /// products with the variables of a base, each as one number for each part.
  struct Direction {
    std::vector<double> pull, curvature, cross;
  };
  [[nodiscard]] Direction direction_of(const Base& base, std::size_t added, const std::array<double, 3>& by);
  /// Returns how far each variable of the base gives way for one unit of a direction.
  [[nodiscard]] std::vector<double> answer_to(const Base& base, const std::vector<double>& cross) const;
  /// Returns the energy after a step along a direction, without stiffness. The base gives way by `answer` times the
  /// step.
  [[nodiscard]] double energy_along(const Base& base, const Direction& direction, std::span<const double> answer,
                                    double step) const;
  /// Returns the products of a unit's members (1, 0), (2, 0) and (2, 1), each as one number for each part. Computes
  /// them once.
  [[nodiscard]] const std::vector<double>& between(std::size_t u);
  /// Does what `guess` does, for units whose members are not tied.
  [[nodiscard]] std::optional<double> guess_several(const Base& base, std::size_t unit);
  /// The energy about where one more unit and the base meet its pull, apart from what it costs beside them; nothing
  /// where that moves nothing.
  [[nodiscard]] std::optional<double> guess(const Base& base, std::size_t unit);
  /// Adds, exchanges and removes units, one at a time, while that lowers the energy.
  [[nodiscard]] Choice climb(Choice current, std::size_t most);
  /// The best single unit tried that a choice neither holds nor excludes.
  [[nodiscard]] std::optional<Choice> best_beside(const Choice& found) const;
  void try_all(const Choice& from, Choice& best, std::size_t most);

  /// Returns the units that are worth fitting beside a choice: the k_tries best ones by guess and cost.
  [[nodiscard]] std::vector<std::size_t> units_to_try(const Choice& from);

  Quadratic& q_;
  const Choices& choices_;
  const ReadingCosts& costs_;
  const Doubt& doubt_;
  std::vector<std::vector<double>> between_;  ///< one a unit; empty: not asked for yet
  std::vector<Choice> tried_;
  std::size_t evaluations_ = 0;
  BoundedSquares bounded_;
  std::vector<double> matrix_, pulls_, squares_, weights_;
};

}  // namespace penpose::intent
