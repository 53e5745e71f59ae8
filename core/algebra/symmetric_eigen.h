#pragma once

#include <cstddef>
#include <vector>

namespace penpose::algebra {

/// Eigenvalues, largest first, and their vectors of a symmetric matrix.
struct SymmetricEigen {
  std::vector<double> values;
  std::vector<double> vectors;  ///< one run of `size` numbers each, of length one
};

/// By Jacobi's rotations (rotate_to_diagonal). Precondition: `matrix` holds size * size numbers and is symmetric.
[[nodiscard]] SymmetricEigen symmetric_eigen(std::vector<double> matrix, std::size_t size);

}  // namespace penpose::algebra
