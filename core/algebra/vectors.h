#pragma once

#include <array>
#include <cstddef>

namespace penpose::algebra {

// Loops over arrays of doubles. Sums run in four lanes that are added in a fixed order, so that a compiler may use
// whatever vector registers there are without changing a bit. Arrays do not overlap unless they are the same.

/// Sum of a_i b_i.
[[nodiscard]] double dot(const double* a, const double* b, std::size_t count);
/// The same in one sum, from the first to the last; other bits, slower.
[[nodiscard]] double dot_in_order(const double* a, const double* b, std::size_t count);
/// dot(a, b[k], count) of four b at once, to the same bits.
[[nodiscard]] std::array<double, 4> dots(const double* a, const std::array<const double*, 4>& b, std::size_t count);
/// out_i = a_i b_i.
void multiply(const double* a, const double* b, double* out, std::size_t count);
/// out_i += factor a_i.
void add_scaled(double factor, const double* a, double* out, std::size_t count);

}  // namespace penpose::algebra
