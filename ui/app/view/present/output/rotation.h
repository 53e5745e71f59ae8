#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/camera.h"
#include "core/geometry/space.h"
#include "ui/render/cpu/triangles/triangle_raster.h"
#include "ui/render/picture/image.h"

namespace penpose::app {

/// How the picture is turned, clockwise, to stand upright on a panel that is mounted turned.
enum class Rotation : std::uint8_t { none, quarter, half, three_quarters };
/// Of 0, 90, 180 or 270 degrees.
[[nodiscard]] std::optional<Rotation> rotation_of(int degrees);

/// The size of a picture on a panel, or of the panel for a picture: where it lies on its side, they are exchanged.
[[nodiscard]] geometry::Viewport turned_size(geometry::Viewport size, Rotation rotation);
/// The place on the picture that a place on the panel shows; px, `panel` is the panel's size.
[[nodiscard]] geometry::PxPoint on_picture(geometry::PxPoint on_panel, geometry::Viewport panel, Rotation rotation);
/// The part of the panel that shows a part of the picture; `picture` is the picture's size.
[[nodiscard]] render::PxRect on_panel(const render::PxRect& part, geometry::Viewport picture, Rotation rotation);
/// Copies parts of a picture to where the panel shows them. Sets the size of `panel`.
void turn(const render::Image& picture, const std::vector<render::PxRect>& parts, Rotation rotation,
          render::Image& panel);

}  // namespace penpose::app
