#include "core/prior/cholesky.h"

#include <cmath>

namespace penpose::prior {

bool factor(std::vector<double>& matrix, std::size_t n) {
  for (std::size_t column = 0; column < n; ++column) {
    const double* above = matrix.data() + column * n;
    double pivot = above[column];
    for (std::size_t k = 0; k < column; ++k) pivot -= above[k] * above[k];
    if (!(pivot > 0)) return false;
    pivot = std::sqrt(pivot);
    matrix[column * n + column] = pivot;
    for (std::size_t row = column + 1; row < n; ++row) {
      double* own = matrix.data() + row * n;
      double sum = own[column];
      for (std::size_t k = 0; k < column; ++k) sum -= own[k] * above[k];
      own[column] = sum / pivot;
    }
  }
  return true;
}

void solve_factored(const std::vector<double>& matrix, std::size_t n, std::span<double> b) {
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t k = 0; k < row; ++k) b[row] -= matrix[row * n + k] * b[k];
    b[row] /= matrix[row * n + row];
  }
  for (std::size_t row = n; row-- > 0;) {
    for (std::size_t k = row + 1; k < n; ++k) b[row] -= matrix[k * n + row] * b[k];
    b[row] /= matrix[row * n + row];
  }
}

}  // namespace penpose::prior
