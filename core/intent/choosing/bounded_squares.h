#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/intent/choosing/choice.h"

namespace penpose::intent {

/// Least squares within ranges; keeps its scratch memory.
class BoundedSquares {
 public:
  /// The z of least z'Az - 2 b'z with choices.low <= z <= choices.high, one value a variable: Cholesky, and coordinate
  /// descent where that leaves the ranges. `matrix` is A by rows, symmetric and not indefinite; `pulls` is b.
  [[nodiscard]] std::vector<double> solve(std::span<const double> matrix, std::span<const double> pulls,
                                          std::span<const std::size_t> variables, const Choices& choices);

 private:
  std::vector<double> factor_, left_;
};

}  // namespace penpose::intent
