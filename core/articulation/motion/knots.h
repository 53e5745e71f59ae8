#pragma once

#include <span>
#include <vector>

namespace penpose::articulation {

/// One of the amounts at which a deformer has a target beside those at 0 and 1.
struct Knot {
  double amount = 0.5;
  double below = 0;  ///< the neighbouring amounts at which there is something else; its own where there is none
  double above = 1;

  /// What its target counts at an amount: 1 at its own, 0 from the neighbouring ones on, straight between them; where
  /// there is no neighbour it grows on as it came.
  [[nodiscard]] double weight(double at) const;
};

/// Precondition: ascending amounts, none of them 0 or 1.
[[nodiscard]] std::vector<Knot> knots_of(std::span<const double> amounts);

}  // namespace penpose::articulation
