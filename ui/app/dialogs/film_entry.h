#pragma once

#include "core/geometry/camera.h"

namespace penpose::app {

/// What is chosen for the next film.
struct FilmEntry {
  geometry::Viewport size{1280, 720};
};

}  // namespace penpose::app
