#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "core/document/drawing/pose_curve.h"
#include "ui/app/view/area.h"
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

/// Degrees of the height of a picture with perspective; and of one so flat that it has next to none: what is nearer by
/// the depth of a head is larger by less than a hundredth.
inline constexpr double k_usual_degrees = 24;
inline constexpr double k_flat_degrees = 1;

/// The camera with another field of view, from where what it looks at is as large as before.
[[nodiscard]] geometry::CameraPose with_field_of_view(const geometry::CameraPose& camera, double degrees);

/// The camera turned to look from a direction, as near as it was: what is under `about` stays there.
[[nodiscard]] geometry::CameraPose seen_from(const document::View& view, const render::Viewpoint& from, PxPoint about);

/// A view of the whole window whose part `free`, which no panel covers, shows all the points.
[[nodiscard]] document::View framed(std::span<const glm::vec3> points, geometry::Viewport window, const Area& free,
                                    const render::Viewpoint& from);

/// The direction in which a camera looks, as framing names it.
[[nodiscard]] render::Viewpoint viewpoint_of(const geometry::CameraPose& camera);

}  // namespace penpose::app
