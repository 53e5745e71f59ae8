#pragma once

#include <array>
#include <cstddef>

namespace penpose::intent {

/// Modes by which the points of a curve slide along a line: two for its ends, four in between.
inline constexpr std::size_t k_modes = 6;
using Modes = std::array<double, k_modes>;
using ModeMatrix = std::array<Modes, k_modes>;

[[nodiscard]] double times(const Modes& a, const Modes& b);
/// m += weight a a'.
void grow(ModeMatrix& m, const Modes& a, double weight);
/// Lower Cholesky factor of I + m, m positive semidefinite.
[[nodiscard]] ModeMatrix factor_of(ModeMatrix m);
/// L^-1 b in place.
void solve_forward(const ModeMatrix& l, double* b);
/// (I + m)^-1 b.
[[nodiscard]] Modes solve_modes(const ModeMatrix& m, Modes b);

}  // namespace penpose::intent
