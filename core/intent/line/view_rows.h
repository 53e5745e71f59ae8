#pragma once

#include <optional>

#include "core/geometry/camera.h"

namespace penpose::intent {

/// How a point near `at` moves in a picture when it moves in space: px along x and y for one model unit along each
/// axis, and model units along the ray.
struct ViewDerivative {
  geometry::ModelVector x{0};    ///< px for one unit
  geometry::ModelVector y{0};    ///< px for one unit
  geometry::ModelVector ray{0};  ///< away from the eye, px-sized units: one unit of depth counts as many px as across
};

/// Nothing when the point lies behind the camera.
[[nodiscard]] std::optional<ViewDerivative> view_derivative(const geometry::Camera& camera,
                                                            const geometry::ModelPoint& at);

}  // namespace penpose::intent
