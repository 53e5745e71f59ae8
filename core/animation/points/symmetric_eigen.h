#pragma once

#include <vector>

namespace penpose::animation {

/// Eigenvalues, largest first, and their vectors of a symmetric matrix.
struct SymmetricEigen {
  std::vector<double> values;
  std::vector<double> vectors;  ///< one run of `size` numbers each, of length one
};

/// Jacobi's rotations in a fixed order (Golub and Van Loan, section 8.5). Precondition: `matrix` holds size * size
/// numbers and is symmetric.
[[nodiscard]] SymmetricEigen symmetric_eigen(std::vector<double> matrix, std::size_t size);

}  // namespace penpose::animation
