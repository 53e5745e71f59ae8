#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/document/pose_curve.h"
#include "ui/app/area.h"
#include "ui/render/framing.h"

namespace penpose::app {

/// The camera turned about what it looks at, like a model on a turntable: `yaw` about +Y, `pitch` up and down, which
/// stops short of the poles. Degrees; positive values move the camera to its right and up.
[[nodiscard]] geometry::CameraPose orbited(const geometry::CameraPose& camera, double yaw, double pitch);

/// The view moved so that what lies at the depth of its middle follows a pointer that moved by some px.
[[nodiscard]] geometry::CameraPose panned(const document::View& view, PxPoint by);

/// The camera nearer (`factor` below 1) or farther, while what is under `about` stays there. `size`: the model's
/// diagonal, which bounds how near and how far one may go.
[[nodiscard]] geometry::CameraPose zoomed(const document::View& view, double factor, PxPoint about, double size);

/// A view of the whole window whose part `free`, which no panel covers, shows all the points.
[[nodiscard]] document::View framed(std::span<const glm::vec3> points, geometry::Viewport window, const Area& free,
                                    const render::Viewpoint& from);

/// The direction in which a camera looks, as framing names it.
[[nodiscard]] render::Viewpoint viewpoint_of(const geometry::CameraPose& camera);

}  // namespace penpose::app
