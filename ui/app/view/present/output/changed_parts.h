#pragma once

#include <vector>

#include "ui/render/cpu/triangles/triangle_raster.h"
#include "ui/render/picture/image.h"

namespace penpose::app {

/// Rectangles, in px, that hold all in which a picture differs from the one before: few, and none over another. All of
/// it where their sizes differ.
[[nodiscard]] std::vector<render::PxRect> changed_parts(const render::Image& before, const render::Image& now);

}  // namespace penpose::app
