#pragma once

#include <optional>

#include "core/geometry/camera.h"

namespace penpose::app {

/// The size that what is drawn into has by now, of the OpenGL context that is current. SDL says what it has asked a
/// window manager for, which on a screen without one is not what came of it. Nothing where it cannot be asked (on
/// X11 alone it can).
[[nodiscard]] std::optional<geometry::Viewport> drawable_size();

}  // namespace penpose::app
