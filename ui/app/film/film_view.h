#pragma once

#include "core/geometry/camera.h"
#include "ui/app/view/area.h"
#include "ui/film/film_frames.h"

namespace penpose::app {

/// A camera and the part of its picture that is filmed.
struct FilmView {
  geometry::CameraPose camera;
  geometry::Viewport whole;  ///< of the camera's picture, px
  film::PxPart part;
};

/// What shows all that the part `free` of a window's picture shows, in its middle and as large as there is room for.
/// `camera`: of the whole window.
[[nodiscard]] FilmView film_view(const geometry::CameraPose& camera, geometry::Viewport window, const Area& free,
                                 geometry::Viewport size);

/// The canvas as it is, in px of the window; even, as films want it.
[[nodiscard]] geometry::Viewport film_size(const Area& free);

}  // namespace penpose::app
