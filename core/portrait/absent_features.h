#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/portrait/proportions.h"

namespace penpose::portrait {

/// A feature that drawings of faces have and a model does not.
struct AbsentFeature {
  Part part = Part::other;
  std::optional<std::size_t> meant;       ///< the curve of the model that stands for it; none: nothing moves it
  std::vector<geometry::PxPoint> points;  ///< as many as the lines have
};

/// Brows, the outline of the face and the wings of the nose where faces have them beside the eyes and the mouth that a
/// model has: a line of the drawing that is one of these is not to be taken for something else. None for a face without
/// eyes of both sides. `lines`: of the picture, px, y down.
[[nodiscard]] std::vector<AbsentFeature> absent_features(std::span<const std::vector<geometry::PxPoint>> lines,
                                                         std::span<const Part> parts);

}  // namespace penpose::portrait
