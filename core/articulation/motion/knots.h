#pragma once

#include <span>
#include <vector>

namespace penpose::articulation {

/// An amount other than 0 and 1 at which a deformer has a target.
struct Knot {
  double amount = 0.5;
  double below = 0;  ///< the neighbouring amounts with targets; its own where there is none
  double above = 1;

  /// The weight of its target at an amount: 1 at its own, 0 from the neighbouring ones on, linear between them, and
  /// extrapolated where there is no neighbour.
  [[nodiscard]] double weight(double at) const;
};

/// Precondition: ascending amounts, none of them 0 or 1.
[[nodiscard]] std::vector<Knot> knots_of(std::span<const double> amounts);

}  // namespace penpose::articulation
