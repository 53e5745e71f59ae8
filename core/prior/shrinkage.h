#pragma once

#include <cstddef>

namespace penpose::prior {

/// How far a covariance estimated from few samples is drawn to a multiple of the identity, 0..1: the oracle
/// approximating shrinkage of Chen, Wiesel, Eldar and Hero, "Shrinkage algorithms for MMSE covariance estimation", IEEE
/// Transactions on Signal Processing 58(10), 2010, equation 23, in closed form:
///
///   rho = min(1, ((1 - 2/p) tr(S^2) + tr(S)^2) / ((n + 1 - 2/p) (tr(S^2) - tr(S)^2 / p)))
///
/// for n samples of p numbers. `trace` is tr(S), `trace_of_square` tr(S^2). 1 where all directions spread alike, so
/// that nothing is to be learned of them. Precondition: n > 0, p > 0.
[[nodiscard]] double oracle_shrinkage(std::size_t n, std::size_t p, double trace, double trace_of_square);

}  // namespace penpose::prior
