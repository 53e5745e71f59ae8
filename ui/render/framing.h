#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "core/geometry/camera.h"

namespace penpose::render {

/// A direction to look from: turned about +Y from the front (0: from +Z, 90: from +X), raised by the pitch.
struct Viewpoint {
  double yaw_degrees = 25;
  double pitch_degrees = 6;
};

/// "front", "side" (the subject's left), "three-quarter", "back" or "top"; nothing for another name.
[[nodiscard]] std::optional<Viewpoint> find_viewpoint(std::string_view name);

/// A camera that shows all points with a margin of a twelfth of the picture on the two tight sides, whatever their
/// units and size. It fits the points themselves, which fills the picture better than their box does. No points: a unit
/// box around the origin.
[[nodiscard]] geometry::Camera frame_points(std::span<const glm::vec3> points, geometry::Viewport viewport,
                                            const Viewpoint& from = {}, double vertical_fov_degrees = 24);

}  // namespace penpose::render
