#pragma once

#include <span>

#include "core/geometry/camera.h"
#include "ui/render/cpu/triangles/triangle_raster.h"
#include "ui/render/picture/image.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Draws curves over a picture of the camera's size, highlighted ones last, as k_curve_fragment in
/// ui/render/gl/shaders.h does: at each px the piece whose middle line is nearest, measured from its edge, gives the
/// colour, so that nothing is blended twice. Over a clear picture this gives colours times their alpha. Gives the px
/// outside of which nothing was drawn.
PxRect draw_curves(std::span<const CurveDrawing> curves, const geometry::Camera& camera, Image& picture);

}  // namespace penpose::render
