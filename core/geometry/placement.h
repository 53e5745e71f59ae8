#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/space.h"

namespace penpose::geometry {

/// Where a model stands in a scene: scaled, then turned about +y, then moved. Such placements after one another are one
/// again.
struct Placement {
  ModelVector at{0};
  double turn_degrees = 0;  ///< +z goes to +x by 90
  double scale = 1;         ///< above 0
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// Directions keep their length.
[[nodiscard]] ModelVector turned(const Placement& placement, const ModelVector& direction);
[[nodiscard]] ModelPoint placed(const Placement& placement, const ModelPoint& point);
/// The camera that sees of the placed model what the camera sees of the model.
[[nodiscard]] CameraPose placed(const Placement& placement, const CameraPose& camera);
/// The placement that brings all back.
[[nodiscard]] Placement inverse(const Placement& placement);
/// `first`, and `then` what came of it.
[[nodiscard]] Placement joined(const Placement& first, const Placement& then);

}  // namespace penpose::geometry
