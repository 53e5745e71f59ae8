#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace penpose::document {

/// Curves that are known at many moments: what was performed or tracked, frame by frame.
struct DenseCurves {
  std::span<const double> times_s;     ///< ascending, no two alike
  std::span<const double> values;      ///< a row a moment, one value a curve
  std::span<const double> tolerances;  ///< one a curve, > 0 in its units: how far it may be off; infinite: however far
};

/// The moments that are enough: smooth interpolation between them (monotone_tangents, as KeyInterpolation::smooth) is
/// off by no more than the tolerance at every moment of every curve. Ascending numbers of moments; the first, the last
/// and those of `fixed` are among them. None of the others can be left out alone. The least number is not promised.
/// Precondition: as many values as moments times curves; `fixed` are numbers of moments.
[[nodiscard]] std::vector<std::size_t> enough_moments(const DenseCurves& curves,
                                                      std::span<const std::size_t> fixed = {});

}  // namespace penpose::document
