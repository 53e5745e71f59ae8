#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/document/model.h"
#include "core/geometry/camera.h"

namespace penpose::render {

/// A direction to look from: turned about +Y from the front (0: from +Z, 90: from +X), raised by the pitch.
struct Viewpoint {
  double yaw_degrees = 25;
  double pitch_degrees = 6;
};

/// "front", "side" (the subject's left), "three-quarter", "back" or "top"; nothing for another name. By a front that
/// is +Z: Model::front_yaw_degrees is added to the yaw.
[[nodiscard]] std::optional<Viewpoint> find_viewpoint(std::string_view name);

/// The vertices around the face of a whole figure: those in the box of what most blend shapes move, widened by
/// two fifths of its height, so that the face from chin to hair fills about two thirds of a picture. Shapes that move
/// half of the figure or more, or that lie a quarter of it away from the middle one, do not count, nor does the fifth
/// that reaches farthest to each side. Empty: nothing says where a face is, or it is most of the model already.
[[nodiscard]] std::vector<std::uint32_t> face_vertices(const document::Model& model);

/// A camera that shows all points with a margin of a twelfth of the picture on the two tight sides, whatever their
/// units and size. It fits the points themselves, which fills the picture better than their box does. No points: a unit
/// box around the origin.
[[nodiscard]] geometry::Camera frame_points(std::span<const glm::vec3> points, geometry::Viewport viewport,
                                            const Viewpoint& from = {}, double vertical_fov_degrees = 24);

}  // namespace penpose::render
