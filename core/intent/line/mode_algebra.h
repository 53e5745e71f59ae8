#pragma once

#include <array>
#include <cstddef>

namespace penpose::intent {

/// Modes by which the points of a curve slide along a line: two for its ends, four in between.
inline constexpr std::size_t k_modes = 6;
using Modes = std::array<double, k_modes>;
using ModeMatrix = std::array<Modes, k_modes>;

[[nodiscard]] inline double times(const Modes& a, const Modes& b) {
  double sum = 0;
  for (std::size_t i = 0; i < k_modes; ++i) sum += a[i] * b[i];
  return sum;
}
/// m += weight a a'.
inline void grow(ModeMatrix& m, const Modes& a, double weight) {
  for (std::size_t i = 0; i < k_modes; ++i) {
    for (std::size_t k = 0; k < k_modes; ++k) m[i][k] += weight * a[i] * a[k];
  }
}
/// Lower Cholesky factor of I + m, m positive semidefinite.
[[nodiscard]] ModeMatrix factor_of(ModeMatrix m);
/// L^-1 b in place.
void solve_forward(const ModeMatrix& l, double* b);
/// (I + m)^-1 b.
[[nodiscard]] Modes solve_modes(const ModeMatrix& m, Modes b);

}  // namespace penpose::intent
