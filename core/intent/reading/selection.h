#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/intent/reading/quadratic.h"

namespace penpose::intent {

/// Controls that are chosen together: one parameter, a left and a right one, or the angles of one joint. `members` are
/// numbers of variables.
struct Unit {
  std::array<std::size_t, 3> members{};
  std::size_t count = 1;
  bool tied = false;  ///< left and right: drawn alike they move alike
  double charge = 0;  ///< what choosing it costs beside what all units cost
};

/// The variables of a choice: changes of parameters, each as a share of its range.
struct Choices {
  std::vector<Unit> units;
  std::vector<double> low, high;  ///< one a variable, low <= 0 <= high
  std::vector<double> movement;   ///< of the whole model, one a variable (WholeModel::movement)
  std::vector<double> stiffness;  ///< what the square of a variable costs; twists of joints cost more
};

/// Some units with their values: what one reading of the strokes comes to.
struct Choice {
  std::vector<std::size_t> units;      ///< numbers of units, ascending
  std::vector<std::size_t> variables;  ///< their members, ascending, without repeats
  std::vector<double> values;          ///< one a variable
  double energy = 0;                   ///< squares and costs
  double costs = 0;                    ///< of its units alone
};

/// The energy of a choice: E of the curves, and what leaving the pose costs. Each unit that moves costs a constant; the
/// logarithm of how exactly the drawn curves would tell its value (a control that must move by a hundredth of its range
/// is a less likely reading than one that moves by half: the evidence of Bayesian model comparison, MacKay 1992); and
/// the logarithms of how far it moves the whole model, other parts of it, what surrounds the curve, and the curve along
/// itself. A control near an end of its range costs more, and so does a pair whose sides differ. Few controls rather
/// than many, and those that go where the pen went and move little else.
struct Costs {
  double unit = 8.0;
  double evidence = 1.0;   ///< times log(1 + curvature)
  double movement = 4.0;   ///< times log(1 + way of the whole model / usual way)
  double usual_way = 0.2;  ///< of the whole model, as a multiple of the median control's
  double beside = 8.0;     ///< times log(way of what it moves most / way of the curve that it moves most), if positive
  double around = 20.0;    ///< times log(what lies next to the curve goes away from it / way of the curve), if positive
  double along = 4.0;      ///< times log(way of the curve / its way less that from one of its ends to the other)
  double limit = 8.0;      ///< each that stands at an end of its range: it is asked for more than it can
  double limit_from = 0.8;  ///< share of the way to an end of its range from which on that grows evenly to all of it
  double tie = 40.0;        ///< the square of what a pair's two values differ by
};

/// How far a value is on its way to the end of its range, 0 to 1; 0 where it has none on that side.
[[nodiscard]] double share_of_range(double value, std::size_t variable, const Choices& choices);
/// Whether a value of a choice that is not 0 stands at an end of its range.
[[nodiscard]] bool stands_at_limit(const Choice& choice, const Choices& choices);

class Selection {
 public:
  Selection(Quadratic& quadratic, const Choices& choices, const Costs& costs)
      : q_(quadratic), choices_(choices), costs_(costs) {}

  /// The least energy of these units: least squares within the ranges.
  [[nodiscard]] Choice fit(std::vector<std::size_t> units);
  /// The best choice found from a first one on: units are added, exchanged and taken out, one at a time, while that
  /// lowers the energy. `most`: units at most. Deterministic: equal energies keep the choice that came first.
  [[nodiscard]] Choice select(Choice first, std::size_t most);
  /// Something has to move: a choice of nothing is none. A selection may yet come to nothing where there is no unit.
  void forbid_nothing() { something_ = true; }
  /// Other choices that come near the last selection's: one exchange away, at most `window` above it, the best first.
  [[nodiscard]] const std::vector<Choice>& rivals() const { return rivals_; }
  void set_rivals(std::size_t count, double window) {
    rival_count_ = count;
    rival_window_ = window;
  }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }
  /// What those units cost more that stand at an end of a range.
  [[nodiscard]] double limit_costs(const Choice& choice) const;
  /// What the units of a choice cost at its values, with what pairs differ by, without limit_costs.
  [[nodiscard]] double costs_of(const Choice& choice) const;

 private:
  /// A choice that units are added to: its matrix factored, so that what one more could gain is known at once.
  struct Base {
    Choice choice;
    std::vector<double> factor;  ///< lower Cholesky factor of the choice's matrix, by rows
  };
  /// How many stand at an end of their range, those near it (Costs::limit_from) in parts.
  [[nodiscard]] double units_near_limit(const Choice& choice) const;
  [[nodiscard]] double unit_cost(const Unit& unit, const Choice& choice) const;
  [[nodiscard]] double value_of(const Choice& choice, std::size_t variable) const;
  [[nodiscard]] bool overlaps(std::size_t a, std::size_t b) const;
  [[nodiscard]] bool overlaps(const Choice& choice, std::size_t unit) const;
  /// Fills matrix_ and pulls_ for a choice's variables.
  void set_up(const Choice& choice);
  void solve_within_ranges(Choice& choice);
  [[nodiscard]] Base base_of(Choice choice);
  /// The energy of the base with a unit added is no lower than this, but for variables of the base that stand at an end
  /// of their range.
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
  std::vector<double> matrix_, pulls_, descent_, solved_;
};

}  // namespace penpose::intent
