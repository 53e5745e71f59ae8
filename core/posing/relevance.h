#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/posing/curve_system.h"

namespace penpose::posing {

/// The parameters that move the curves, and how far.
struct Relevance {
  std::vector<std::size_t> parameters;  ///< ascending
  std::vector<double> effects;          ///< sum over the points of how far the parameter moves them within its range
  /// Columns of the parameters (see CurveSystem::columns) where the rig is linear in all of them.
  std::optional<std::vector<Column>> columns;
};

/// Drops every free parameter that moves no curve point by more than `threshold` (model units) anywhere in its range,
/// with the others at `pose`. A rig that is not linear in a parameter is tried at nine values of it.
[[nodiscard]] Relevance relevant_parameters(CurveSystem& system, std::span<const double> pose,
                                            std::span<const std::size_t> free, double threshold);

}  // namespace penpose::posing
