#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/intent/choosing/bounded_squares.h"
#include "core/intent/choosing/choice.h"
#include "core/intent/choosing/quadratic.h"

namespace penpose::intent {

/// The energy of a choice: E of the curves plus the cost of leaving the pose. Each unit that moves costs a constant;
/// the logarithm of how exactly the drawn curves determine its value (a control that must move by a hundredth of its
/// range is a less likely reading than one that moves by half: the evidence of Bayesian model comparison, MacKay 1992);
/// and the logarithms of how far it moves the whole model, other parts of it, and the curve along itself. A control
/// near an end of its range costs more, and so does a pair whose sides differ. This prefers few controls over many, and
/// those that follow the pen and move little else.
struct Costs {
  double unit = 8.0;
  double evidence = 1.0;     ///< times log(1 + curvature)
  double movement = 4.0;     ///< times log(1 + movement of the whole model / usual_way)
  double usual_way = 0.2;    ///< of the whole model, as a multiple of the median control's
  double side_effect = 8.0;  ///< times log(largest displacement / largest of a curve), if positive
  double tangential = 4.0;   ///< times log(displacement of the curve / its part across the curve's chord)
  double limit = 8.0;        ///< each control at an end of its range: the line goes beyond it
  double limit_from = 0.8;   ///< share of the way to an end of the range from which `limit` grows linearly
  double tie = 40.0;         ///< times the square of the difference of a pair's values
};

class Selection : public ChoiceCosts {
 public:
  Selection(Quadratic& quadratic, const Choices& choices, const Costs& costs)
      : q_(quadratic), choices_(choices), costs_(costs) {}

  /// The least energy of these units: least squares within the ranges.
  [[nodiscard]] Choice fit(std::vector<std::size_t> units);
  /// The best choice found from a first one: adds, exchanges and removes units, one at a time, while that lowers the
  /// energy. `most`: units at most. Deterministic: equal energies keep the choice that came first.
  [[nodiscard]] Choice select(Choice first, std::size_t most);
  /// Requires something to move: an empty choice is not allowed, unless there is no unit at all.
  void forbid_nothing() { something_ = true; }
  /// Other choices near the last selection: one exchange away, at most `window` above it, the best first.
  [[nodiscard]] const std::vector<Choice>& rivals() const { return rivals_; }
  void set_rivals(std::size_t count, double window) {
    rival_count_ = count;
    rival_window_ = window;
  }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }
  [[nodiscard]] double limit_costs(const Choice& choice) const override;
  [[nodiscard]] double costs_of(const Choice& choice) const override;

 private:
  /// A choice to add units to, with its matrix factored, so that the gain of one more is quickly found.
  struct Base {
    Choice choice;
    std::vector<double> factor;  ///< lower Cholesky factor of the choice's matrix, by rows
  };
  /// How many are at an end of their range; those near it (Costs::limit_from) count in part.
  [[nodiscard]] double units_near_limit(const Choice& choice) const;
  [[nodiscard]] double unit_cost(const Unit& unit, const Choice& choice) const;
  [[nodiscard]] double value_of(const Choice& choice, std::size_t variable) const;
  [[nodiscard]] bool overlaps(std::size_t a, std::size_t b) const;
  [[nodiscard]] bool overlaps(const Choice& choice, std::size_t unit) const;
  /// Fills matrix_ and pulls_ for a choice's variables.
  void set_up(const Choice& choice);
  [[nodiscard]] Base base_of(Choice choice);
  /// A lower bound of the energy of the base with a unit added, except for variables of the base at an end of their
  /// range.
  [[nodiscard]] double least_with(const Base& base, std::size_t unit);
  void try_all(const Base& base, Choice& best, std::size_t most);
  [[nodiscard]] double worth(const Choice& choice) const;
  void consider(std::vector<std::size_t> units, Choice& best);

  Quadratic& q_;
  const Choices& choices_;
  const Costs& costs_;
  std::vector<Choice> rivals_;
  std::size_t rival_count_ = 0;
  bool something_ = false;
  double rival_window_ = 0;
  std::size_t evaluations_ = 0;
  BoundedSquares squares_;
  std::vector<double> matrix_, pulls_, solved_;
};

}  // namespace penpose::intent
