#pragma once

#include <cstddef>

namespace penpose::posing {

// Loops over arrays of doubles. Sums run in four lanes that are added in a fixed order, so that a compiler may use
// whatever vector registers there are without changing a bit. Arrays do not overlap unless they are the same.

/// Sum of a_i b_i.
[[nodiscard]] double dot(const double* a, const double* b, std::size_t count);
/// out_i = a_i b_i.
void multiply(const double* a, const double* b, double* out, std::size_t count);
/// out_i += factor a_i.
void add_scaled(double factor, const double* a, double* out, std::size_t count);
/// Sum of w_i times the length of (x_i, y_i, z_i), the axes one after the other in `residuals`. Precondition: stride is
/// a multiple of four.
[[nodiscard]] double weighted_lengths(const double* residuals, const double* weights, std::size_t stride);

}  // namespace penpose::posing
